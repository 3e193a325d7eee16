main = simulate dance

dance :: Task ()
dance = do
  side <- pure LeftBumper
