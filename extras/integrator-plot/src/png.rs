//! Encoding of pixels as PNG: the signature, then the header, data and end chunks, each with its length and checksum.

use crc::{CRC_32_ISO_HDLC, Crc};
use miniz_oxide::deflate::compress_to_vec_zlib;

const SUM: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);
/// Between speed and size, as most writers have it.
const LEVEL: u8 = 6;

/// A file of an image, three bytes for each pixel, row after row.
pub(crate) fn encoded((width, height): (u32, u32), rgb: &[u8]) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut head = [width.to_be_bytes(), height.to_be_bytes()].concat();
    // Eight bits for each of three colours, the only compression and the only kind of filters, no interlacing.
    head.extend([8, 2, 0, 0, 0]);
    // Pictures with large areas of one colour are smallest without a filter, which every row says of itself.
    let rows = rgb.chunks(3 * width.max(1) as usize).flat_map(|row| [0].into_iter().chain(row.iter().copied()));
    let rows = compress_to_vec_zlib(&rows.collect::<Vec<u8>>(), LEVEL);
    for (name, bytes) in [(b"IHDR", &head[..]), (b"IDAT", &rows), (b"IEND", &[])] {
        let chunk = [&name[..], bytes].concat();
        file.extend((bytes.len() as u32).to_be_bytes());
        file.extend(&chunk);
        file.extend(SUM.checksum(&chunk).to_be_bytes());
    }
    file
}

#[cfg(test)]
mod tests {
    use super::encoded;
    use miniz_oxide::inflate::decompress_to_vec_zlib;

    #[test]
    fn a_file_has_its_signature_its_chunks_and_its_rows() {
        let pixels: Vec<u8> = (0..2 * 3 * 3).collect();
        let file = encoded((2, 3), &pixels);
        assert!(file.starts_with(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x02\0\0\0\x03\x08\x02\0\0\0"));
        // The end has the same check sum in every file.
        assert!(file.ends_with(b"\0\0\0\0IEND\xaeB`\x82"));
        let begin = file.windows(4).position(|name| name == b"IDAT").expect("rows") + 4;
        let rows = decompress_to_vec_zlib(&file[begin..file.len() - 16]).expect("a zlib stream");
        let expected: Vec<u8> = pixels.chunks(6).flat_map(|row| [&[0], row].concat()).collect();
        assert_eq!(rows, expected);
    }
}
