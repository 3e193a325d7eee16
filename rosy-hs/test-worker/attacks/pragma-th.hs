{-# LANGUAGE TemplateHaskell #-}
main = $(error "HARM")
