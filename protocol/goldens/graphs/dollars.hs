-- A task behind several dollar signs.
main = simulate $
  forever $ do
    driveUntilBump
    replicateM_ 2 $ race_ (wait 1) $ turn 90
