{-# LANGUAGE QuasiQuotes #-}
main = simulate (Say [file|CANARY|])
