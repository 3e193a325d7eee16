when Bumper Pressed:
  play ErrorSound

main = simulate when
