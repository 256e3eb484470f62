# Rscript run.R MODEL.stan COMPILED.rds DATA.R DRAWS SEED OUT.csv NAME...: samples one chain, and writes the draws of these
# numbers. Prints the seconds of warm-up and sampling. What is compiled is kept in COMPILED.rds.
suppressMessages(library(rstan))
eigen <- file.path(system.file(package = "RcppEigen"), "include")
rstan_options(boost_lib = "/usr/include", eigen_lib = eigen)
given <- commandArgs(trailingOnly = TRUE)
draws <- as.integer(given[4])
if (file.exists(given[2])) {
  model <- readRDS(given[2])
} else {
  model <- stan_model(given[1])
  saveRDS(model, given[2])
}
names <- given[-(1:6)]
fit <- sampling(model, data = read_rdump(given[3]), chains = 1, iter = draws + draws %/% 4, warmup = draws %/% 4, seed = as.integer(given[5]), refresh = 0)
write.table(as.matrix(fit, pars = names), given[6], sep = ",", row.names = FALSE, col.names = FALSE)
cat(sum(get_elapsed_time(fit)), "\n")
