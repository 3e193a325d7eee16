main = main
