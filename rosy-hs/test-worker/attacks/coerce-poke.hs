import Foreign

main = poke (nullPtr `plusPtr` 8 :: Ptr Int) 7 >> simulate (Velocity 0 0)
