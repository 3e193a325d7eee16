main = simulate $ do
  forM_ [1, 2, 3] \n -> say (show n)
  wait 1
