import Foreign

main = peek (nullPtr :: Ptr Int) >>= \n -> simulate (Say (show n))
