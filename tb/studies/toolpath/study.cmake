# G-code programs, drawn on the linear and the circular machine.
set(STUDY_DESIGNS linear circular)
set(STUDY_MODELS toolpath prior_art)
