# The same work by every algorithm that can do it.
set(STUDY_DESIGNS linear circular dda)
set(STUDY_STUDIES toolpath)
set(STUDY_MODELS prior_art)
