pause :: Task () ()
pause = wait 1

main = simulate pause
