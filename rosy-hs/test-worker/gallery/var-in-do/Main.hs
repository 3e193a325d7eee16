main = simulate $ do
  var speed = 5
  drive speed
