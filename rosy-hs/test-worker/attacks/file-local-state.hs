import Foreign.Marshal.Unsafe (unsafeLocalState)

main = simulate (Say (unsafeLocalState (readFile "CANARY")))
