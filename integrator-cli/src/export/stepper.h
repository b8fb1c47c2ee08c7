
/* A stage: the fractions of the step that the drift, the kick, its gradient and the parts between them last, and the
   fractions at which drift and kick begin. */
typedef struct { double drift, kick, gradient, drift_time, kick_time, within, behind; } NAME_stage;

/* A composition: the first stage of the first step, the one that completes a step, those of a step in the middle of a run, and
   those of a processor (a negative number of stages if a kick comes first in them). */
typedef struct { int leads_with_kick, cycle, before, after; const NAME_stage *stages; } NAME_composition;

@tangent|/* The derivative of a drift or of a kick is a drift, or a kick along the Hessian of V. */
static inline void NAME_drift_all(NAME_motion *motion, NAME_motion *tangent, double duration, double at) {
@tangent|    if (tangent) NAME_drift(tangent, duration, at);
@plain|    (void)tangent;
    NAME_drift(motion, duration, at);
}
static inline void NAME_kick_all(NAME_motion *motion, NAME_motion *tangent, double duration, double at) {
@tangent|    if (tangent) {
@tangent|        NAME_motion bent = *motion;
@tangent|        memcpy(bent.p, tangent->q, sizeof bent.p);
@tangent|        NAME_hessian(&bent, at);
@tangent|        for (int i = 0; i < COUNT; ++i) tangent->p PLACE = fma(-duration, bent.p PLACE, tangent->p PLACE);
@tangent|    }
@plain|    (void)tangent;
    NAME_kick(motion, duration, at);
}
@middle|static inline void NAME_middle_all(NAME_motion *motion, double duration, double at, int backwards) {
@middle|    if (duration != 0.0) NAME_middle(motion, duration, at, backwards);
@middle|}
@gradient|/* The exact flow of duration V + gradient |grad V|^2, from flows of motions that start at rest. */
@gradient|static inline void NAME_gradient_kick(NAME_motion *motion, double duration, double gradient, double at) {
@gradient|    NAME_motion force = *motion, bent = *motion;
@gradient|    memset(force.p, 0, sizeof force.p);
@gradient|    NAME_kick(&force, -1.0, at);
@gradient|    for (int i = 0; i < COUNT; ++i) motion->p PLACE = fma(-duration, force.p PLACE, motion->p PLACE);
@gradient|    memset(force.q, 0, sizeof force.q);
@gradient|    NAME_drift(&force, 1.0, at);
@gradient|    memcpy(bent.p, force.q, sizeof bent.p);
@gradient|    NAME_hessian(&bent, at);
@gradient|    for (int i = 0; i < COUNT; ++i) motion->p PLACE = fma(-2.0 * gradient, bent.p PLACE, motion->p PLACE);
@gradient|}
static inline void NAME_kick_of(NAME_motion *motion, NAME_motion *tangent, const NAME_stage *stage, double h, double time) {
    const double duration = h * stage->kick, at = time + h * stage->kick_time;
@gradient|    if (stage->gradient != 0.0) {
@gradient|        NAME_gradient_kick(motion, duration, h * h * h * stage->gradient, at);
@gradient|        return;
@gradient|    }
@paired|    NAME_middle(motion, duration / 2.0, at, 0);
    NAME_kick_all(motion, tangent, duration, at);
@paired|    NAME_middle(motion, duration / 2.0, at, 1);
}
static inline void NAME_drift_of(NAME_motion *motion, NAME_motion *tangent, const NAME_stage *stage, double h, double time) {
    NAME_drift_all(motion, tangent, h * stage->drift, time + h * stage->drift_time);
}
static inline void NAME_stage_of(NAME_motion *motion, NAME_motion *tangent, const NAME_stage *stage, int leads_with_kick, double h, double time) {
@middle|    const double before = time + h * stage->kick_time, after = time + h * (stage->kick_time + stage->drift);
    if (leads_with_kick) {
        NAME_kick_of(motion, tangent, stage, h, time);
@middle|        NAME_middle_all(motion, h * stage->within, before, 1);
        NAME_drift_of(motion, tangent, stage, h, time);
@middle|        NAME_middle_all(motion, h * stage->behind, after, 0);
    } else {
        NAME_drift_of(motion, tangent, stage, h, time);
@middle|        NAME_middle_all(motion, h * stage->within, before, 0);
        NAME_kick_of(motion, tangent, stage, h, time);
@middle|        NAME_middle_all(motion, h * stage->behind, before, 1);
    }
}
static inline void NAME_processor(NAME_motion *motion, NAME_motion *tangent, const NAME_stage *rows, int count, double h, double time) {
    const int leads_with_kick = count < 0;
    for (int row = 0; row < (leads_with_kick ? -count : count); ++row) {
        const NAME_stage *stage = &rows[row];
        const int kicks = stage->kick != 0.0 || stage->gradient != 0.0;
        if (kicks && leads_with_kick) NAME_kick_of(motion, tangent, stage, h, time);
        if (stage->drift != 0.0) NAME_drift_of(motion, tangent, stage, h, time);
        if (kicks && !leads_with_kick) NAME_kick_of(motion, tangent, stage, h, time);
    }
}
/* Complete steps. The stages that two steps share are one. */
static inline void NAME_steps(NAME_motion *motion, NAME_motion *tangent, const NAME_composition *of, double t0, double h, uint64_t steps) {
    const NAME_stage *cycle = of->stages + 2, *before = cycle + of->cycle;
    const NAME_stage *after = before + (of->before < 0 ? -of->before : of->before), *closing = &of->stages[1];
    if (steps == 0) return;
    NAME_processor(motion, tangent, before, of->before, h, t0);
    for (uint64_t step = 0; step < steps; ++step) {
        for (int row = 0; row < of->cycle; ++row) {
            const NAME_stage *stage = step == 0 && row == 0 ? &of->stages[0] : &cycle[row];
            NAME_stage_of(motion, tangent, stage, of->leads_with_kick, h, t0 + (double)step * h);
        }
    }
    const double time = t0 + (double)(steps - 1) * h;
    if (of->leads_with_kick) {
        if (closing->kick != 0.0 || closing->gradient != 0.0) NAME_kick_of(motion, tangent, closing, h, time);
    } else if (closing->drift != 0.0) {
        NAME_drift_of(motion, tangent, closing, h, time);
    }
    NAME_processor(motion, tangent, after, of->after, h, time);
}
