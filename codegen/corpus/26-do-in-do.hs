patrol :: Task ()
patrol = forever $ do
  forM_ [1, 2, 3] $ \i -> do
    say ("round " ++ show i)
    when (i > 1) $ do
      say "again"
      wait 1
    unless (i > 2) $
      say "not yet"
  wait 5

main :: IO ()
main = simulate patrol
