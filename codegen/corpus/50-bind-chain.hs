ask :: Task Int
ask = return 3 >>= \x -> return (x + 1) >>= \y -> return (x * y)

tell :: Task ()
tell = ask >>= say . show

seqs :: Task ()
seqs = mapM_ tellOne [1, 2] >> (tell >> tell) *> pure ()
  where tellOne n = say (show n)

lifted :: Task Int
lifted = (+) <$> ask <*> fmap (* 2) ask

main = simulate tell
