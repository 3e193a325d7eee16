bomb :: Task ()
bomb = parallel bomb bomb >> pure ()

main = simulate bomb
