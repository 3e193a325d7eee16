react :: Button -> Say
react (Button n s) =
  if s == Pressed
    then if n == Button0
      then Say "zero"
      else if n == Button1
        then Say "one"
        else Say "two"
    else Say "let go"

main = simulate react
