/// Made by scripts/definitions.ts from rosy-hs/src/Rosy/Motion.hs; not edited by hand.

export const generated: unknown = [
 {
  "name": "drive",
  "block": {
   "type": "define",
   "extraState": {
    "name": "drive",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "Centimeters -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "distance"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "task",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "startDrive",
          "args": 0
         }
        }
       },
       "A1": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "runDrive",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "centimetersToMeters",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "distance",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive so many centimetres ahead (back if negative), keep the heading, and stand still."
    }
   }
  }
 },
 {
  "name": "startDrive",
  "block": {
   "type": "define",
   "extraState": {
    "name": "startDrive",
    "as": "plain",
    "arity": 0,
    "equations": [
     {}
    ],
    "signature": "Pose -> Memory Pose"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "construct",
      "extraState": {
       "con": "Memory",
       "args": 0
      }
     }
    }
   }
  }
 },
 {
  "name": "runDrive",
  "block": {
   "type": "define",
   "extraState": {
    "name": "runDrive",
    "as": "plain",
    "arity": 4,
    "equations": [
     {
      "guards": 1,
      "otherwise": true,
      "where": true
     }
    ],
    "signature": "Meters -> Memory Pose -> Pose -> Velocity -> (Velocity, Maybe (Done ()))"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "goal"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Memory",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Pose",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "start"
            }
           }
          },
          "A1": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "heading"
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Pose",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "here"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "facing"
         }
        }
       }
      }
     }
    },
    "P0_3": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Velocity",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "v"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_any",
         "extraState": {
          "what": "turning, radians a second"
         }
        }
       }
      }
     }
    },
    "C0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "abs",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "rest",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "number",
         "extraState": {
          "value": "0.003"
         }
        }
       }
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 2
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "approach",
             "args": 4
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.05"
               }
              }
             },
             "A1": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.3"
               }
              }
             },
             "A2": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.4"
               }
              }
             },
             "A3": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "rest",
                "args": 0
               }
              }
             }
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "steer",
             "args": 0
            }
           }
          }
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    },
    "O0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 2
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          }
         }
        }
       },
       "I1": {
        "block": {
         "type": "if",
         "inputs": {
          "C": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "<"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "abs",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "v",
                   "args": 0
                  }
                 }
                }
               }
              }
             },
             "R": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.01"
               }
              }
             }
            }
           }
          },
          "T": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Just",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Done",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "tuple",
                  "extraState": {
                   "items": 0
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "F": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Nothing",
             "args": 0
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define_pattern",
      "inputs": {
       "P": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Orientation",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "course"
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "heading",
          "args": 0
         }
        }
       }
      },
      "next": {
       "block": {
        "type": "define_pattern",
        "inputs": {
         "P": {
          "block": {
           "type": "pattern_construct",
           "extraState": {
            "con": "Orientation",
            "args": 1
           },
           "inputs": {
            "A0": {
             "block": {
              "type": "pattern_name",
              "extraState": {
               "name": "deviation"
              }
             }
            }
           }
          }
         },
         "E0_0": {
          "block": {
           "type": "name",
           "extraState": {
            "name": "normOrientation",
            "args": 1
           },
           "inputs": {
            "A0": {
             "block": {
              "type": "infix",
              "extraState": {
               "op": "-"
              },
              "inputs": {
               "L": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "heading",
                  "args": 0
                 }
                }
               },
               "R": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "facing",
                  "args": 0
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        },
        "next": {
         "block": {
          "type": "define_pattern",
          "inputs": {
           "P": {
            "block": {
             "type": "pattern_tuple",
             "extraState": {
              "items": 2
             },
             "inputs": {
              "I0": {
               "block": {
                "type": "pattern_name",
                "extraState": {
                 "name": "x"
                }
               }
              },
              "I1": {
               "block": {
                "type": "pattern_name",
                "extraState": {
                 "name": "y"
                }
               }
              }
             }
            }
           },
           "E0_0": {
            "block": {
             "type": "infix",
             "extraState": {
              "op": "subVec"
             },
             "inputs": {
              "L": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "positionToVec",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "here",
                    "args": 0
                   }
                  }
                 }
                }
               }
              },
              "R": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "positionToVec",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "start",
                    "args": 0
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "next": {
           "block": {
            "type": "define",
            "extraState": {
             "name": "rest",
             "as": "plain",
             "arity": 0,
             "equations": [
              {}
             ]
            },
            "inputs": {
             "E0_0": {
              "block": {
               "type": "infix",
               "extraState": {
                "op": "-"
               },
               "inputs": {
                "L": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "goal",
                   "args": 0
                  }
                 }
                },
                "R": {
                 "block": {
                  "type": "infix",
                  "extraState": {
                   "op": "+"
                  },
                  "inputs": {
                   "L": {
                    "block": {
                     "type": "infix",
                     "extraState": {
                      "op": "*"
                     },
                     "inputs": {
                      "L": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "x",
                         "args": 0
                        }
                       }
                      },
                      "R": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "cos",
                         "args": 1
                        },
                        "inputs": {
                         "A0": {
                          "block": {
                           "type": "name",
                           "extraState": {
                            "name": "course",
                            "args": 0
                           }
                          }
                         }
                        }
                       }
                      }
                     }
                    }
                   },
                   "R": {
                    "block": {
                     "type": "infix",
                     "extraState": {
                      "op": "*"
                     },
                     "inputs": {
                      "L": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "y",
                         "args": 0
                        }
                       }
                      },
                      "R": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "sin",
                         "args": 1
                        },
                        "inputs": {
                         "A0": {
                          "block": {
                           "type": "name",
                           "extraState": {
                            "name": "course",
                            "args": 0
                           }
                          }
                         }
                        }
                       }
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            },
            "next": {
             "block": {
              "type": "define",
              "extraState": {
               "name": "steer",
               "as": "plain",
               "arity": 0,
               "equations": [
                {}
               ]
              },
              "inputs": {
               "E0_0": {
                "block": {
                 "type": "name",
                 "extraState": {
                  "name": "max",
                  "args": 2
                 },
                 "inputs": {
                  "A0": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "-0.5"
                    }
                   }
                  },
                  "A1": {
                   "block": {
                    "type": "name",
                    "extraState": {
                     "name": "min",
                     "args": 2
                    },
                    "inputs": {
                     "A0": {
                      "block": {
                       "type": "number",
                       "extraState": {
                        "value": "0.5"
                       }
                      }
                     },
                     "A1": {
                      "block": {
                       "type": "infix",
                       "extraState": {
                        "op": "*"
                       },
                       "inputs": {
                        "L": {
                         "block": {
                          "type": "number",
                          "extraState": {
                           "value": "2"
                          }
                         }
                        },
                        "R": {
                         "block": {
                          "type": "name",
                          "extraState": {
                           "name": "deviation",
                           "args": 0
                          }
                         }
                        }
                       }
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   }
  }
 },
 {
  "name": "turn",
  "block": {
   "type": "define",
   "extraState": {
    "name": "turn",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "Degrees -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "angle"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "task",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "startTurn",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "degreesToRadians",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "angle",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "A1": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "runTurn",
          "args": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Turn by so many degrees on the spot, to the left (to the right if negative), and stand still."
    }
   }
  }
 },
 {
  "name": "startTurn",
  "block": {
   "type": "define",
   "extraState": {
    "name": "startTurn",
    "as": "plain",
    "arity": 2,
    "equations": [
     {}
    ],
    "signature": "Radians -> Orientation -> Memory (Radians, Orientation)"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "angle"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "heading"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "construct",
      "extraState": {
       "con": "Memory",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "tuple",
         "extraState": {
          "items": 2
         },
         "inputs": {
          "I0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "angle",
             "args": 0
            }
           }
          },
          "I1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "heading",
             "args": 0
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| The angle that is still to turn (radians), and the last heading. It counts whole turns, which a heading does not."
    }
   }
  }
 },
 {
  "name": "runTurn",
  "block": {
   "type": "define",
   "extraState": {
    "name": "runTurn",
    "as": "memory",
    "arity": 3,
    "equations": [
     {
      "guards": 1,
      "otherwise": true,
      "where": true
     }
    ],
    "signature": "Memory (Radians, Orientation) -> Orientation -> Velocity -> (Memory (Radians, Orientation), Velocity, Maybe (Done ()))"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Memory",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_tuple",
         "extraState": {
          "items": 2
         },
         "inputs": {
          "I0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "before"
            }
           }
          },
          "I1": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "last'"
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "heading"
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_construct",
      "extraState": {
       "con": "Velocity",
       "args": 2
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "pattern_any",
         "extraState": {
          "what": "speed, metres a second"
         }
        }
       },
       "A1": {
        "block": {
         "type": "pattern_name",
         "extraState": {
          "name": "w"
         }
        }
       }
      }
     }
    },
    "C0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "abs",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "rest",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "number",
         "extraState": {
          "value": "0.005"
         }
        }
       }
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 3
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "remaining",
          "args": 0
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "approach",
             "args": 4
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.15"
               }
              }
             },
             "A1": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "1.2"
               }
              }
             },
             "A2": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "1.5"
               }
              }
             },
             "A3": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "rest",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "I2": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    },
    "O0": {
     "block": {
      "type": "tuple",
      "extraState": {
       "items": 3
      },
      "inputs": {
       "I0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "remaining",
          "args": 0
         }
        }
       },
       "I1": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Velocity",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          },
          "A1": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0"
            }
           }
          }
         }
        }
       },
       "I2": {
        "block": {
         "type": "if",
         "inputs": {
          "C": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "<"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "abs",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "w",
                   "args": 0
                  }
                 }
                }
               }
              }
             },
             "R": {
              "block": {
               "type": "number",
               "extraState": {
                "value": "0.02"
               }
              }
             }
            }
           }
          },
          "T": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Just",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Done",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "tuple",
                  "extraState": {
                   "items": 0
                  }
                 }
                }
               }
              }
             }
            }
           }
          },
          "F": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Nothing",
             "args": 0
            }
           }
          }
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define_pattern",
      "inputs": {
       "P": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Orientation",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "turned"
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "normOrientation",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "infix",
            "extraState": {
             "op": "-"
            },
            "inputs": {
             "L": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "heading",
                "args": 0
               }
              }
             },
             "R": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "last'",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       }
      },
      "next": {
       "block": {
        "type": "define",
        "extraState": {
         "name": "rest",
         "as": "plain",
         "arity": 0,
         "equations": [
          {}
         ]
        },
        "inputs": {
         "E0_0": {
          "block": {
           "type": "infix",
           "extraState": {
            "op": "-"
           },
           "inputs": {
            "L": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "before",
               "args": 0
              }
             }
            },
            "R": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "turned",
               "args": 0
              }
             }
            }
           }
          }
         }
        },
        "next": {
         "block": {
          "type": "define",
          "extraState": {
           "name": "remaining",
           "as": "plain",
           "arity": 0,
           "equations": [
            {}
           ]
          },
          "inputs": {
           "E0_0": {
            "block": {
             "type": "construct",
             "extraState": {
              "con": "Memory",
              "args": 1
             },
             "inputs": {
              "A0": {
               "block": {
                "type": "tuple",
                "extraState": {
                 "items": 2
                },
                "inputs": {
                 "I0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "rest",
                    "args": 0
                   }
                  }
                 },
                 "I1": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "heading",
                    "args": 0
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   }
  }
 },
 {
  "name": "approach",
  "block": {
   "type": "define",
   "extraState": {
    "name": "approach",
    "as": "plain",
    "arity": 4,
    "equations": [
     {}
    ],
    "signature": "Double -> Double -> Double -> Double -> Double"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "slowest"
      }
     }
    },
    "P0_1": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "fastest"
      }
     }
    },
    "P0_2": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "deceleration"
      }
     }
    },
    "P0_3": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "rest"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": "*"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "signum",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "rest",
             "args": 0
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "max",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "slowest",
             "args": 0
            }
           }
          },
          "A1": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "min",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "fastest",
                "args": 0
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "sqrt",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "infix",
                  "extraState": {
                   "op": "*"
                  },
                  "inputs": {
                   "L": {
                    "block": {
                     "type": "infix",
                     "extraState": {
                      "op": "*"
                     },
                     "inputs": {
                      "L": {
                       "block": {
                        "type": "number",
                        "extraState": {
                         "value": "2"
                        }
                       }
                      },
                      "R": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "deceleration",
                         "args": 0
                        }
                       }
                      }
                     }
                    }
                   },
                   "R": {
                    "block": {
                     "type": "name",
                     "extraState": {
                      "name": "abs",
                      "args": 1
                     },
                     "inputs": {
                      "A0": {
                       "block": {
                        "type": "name",
                        "extraState": {
                         "name": "rest",
                         "args": 0
                        }
                       }
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| A speed towards a goal that is so far away: between a slowest and a fastest speed, such that a constant deceleration ends at the goal.\nTakes slowest, fastest, deceleration and distance, in metres or radians and seconds."
    }
   }
  }
 },
 {
  "name": "driveUntil",
  "block": {
   "type": "define",
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "ctrl"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "do",
      "inputs": {
       "S": {
        "block": {
         "type": "step_bind",
         "inputs": {
          "P": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "result"
            }
           }
          },
          "X": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "task",
             "args": 2
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Velocity",
                "args": 2
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0.2"
                  }
                 }
                },
                "A1": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0"
                  }
                 }
                }
               }
              }
             },
             "A1": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "ctrl",
                "args": 0
               }
              }
             }
            }
           }
          }
         },
         "next": {
          "block": {
           "type": "step_do",
           "inputs": {
            "X": {
             "block": {
              "type": "name",
              "extraState": {
               "name": "once",
               "args": 1
              },
              "inputs": {
               "A0": {
                "block": {
                 "type": "construct",
                 "extraState": {
                  "con": "Velocity",
                  "args": 2
                 },
                 "inputs": {
                  "A0": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "0"
                    }
                   }
                  },
                  "A1": {
                   "block": {
                    "type": "number",
                    "extraState": {
                     "value": "0"
                    }
                   }
                  }
                 }
                }
               }
              }
             }
            }
           },
           "next": {
            "block": {
             "type": "step_do",
             "inputs": {
              "X": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "pure",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "name",
                   "extraState": {
                    "name": "result",
                    "args": 0
                   }
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive ahead (0.2 m/s) until the controller gives 'Done', then stand still.\n\n> driveUntil (\\(Button _ _) -> Done ())"
    }
   },
   "extraState": {
    "name": "driveUntil",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": ""
   }
  },
  "typedByCall": true
 },
 {
  "name": "driveUntilBump",
  "block": {
   "type": "define",
   "extraState": {
    "name": "driveUntilBump",
    "as": "task",
    "arity": 0,
    "equations": [
     {
      "where": true
     }
    ],
    "signature": "Task BumperSide"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "name",
      "extraState": {
       "name": "driveUntil",
       "args": 1
      },
      "inputs": {
       "A0": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "bumped",
          "args": 0
         }
        }
       }
      }
     }
    },
    "W0": {
     "block": {
      "type": "define",
      "extraState": {
       "name": "bumped",
       "as": "event",
       "arity": 1,
       "equations": [
        {},
        {}
       ],
       "signature": "Bumper -> Maybe (Done BumperSide)"
      },
      "inputs": {
       "P0_0": {
        "block": {
         "type": "pattern_construct",
         "extraState": {
          "con": "Bumper",
          "args": 2
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "pattern_name",
            "extraState": {
             "name": "side"
            }
           }
          },
          "A1": {
           "block": {
            "type": "pattern_choice",
            "extraState": {
             "of": "ButtonStatus",
             "value": "Pressed"
            }
           }
          }
         }
        }
       },
       "E0_0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Just",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "construct",
            "extraState": {
             "con": "Done",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "name",
               "extraState": {
                "name": "side",
                "args": 0
               }
              }
             }
            }
           }
          }
         }
        }
       },
       "P1_0": {
        "block": {
         "type": "pattern_any",
         "extraState": {
          "what": "thing"
         }
        }
       },
       "E1_0": {
        "block": {
         "type": "construct",
         "extraState": {
          "con": "Nothing",
          "args": 0
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Drive ahead until a bumper is pressed, and stand still. Its result is the side of the bumper."
    }
   }
  }
 },
 {
  "name": "blink",
  "block": {
   "type": "define",
   "extraState": {
    "name": "blink",
    "as": "task",
    "arity": 1,
    "equations": [
     {}
    ],
    "signature": "LedColor -> Task ()"
   },
   "inputs": {
    "P0_0": {
     "block": {
      "type": "pattern_name",
      "extraState": {
       "name": "color"
      }
     }
    },
    "E0_0": {
     "block": {
      "type": "do",
      "inputs": {
       "S": {
        "block": {
         "type": "step_do",
         "inputs": {
          "X": {
           "block": {
            "type": "name",
            "extraState": {
             "name": "once",
             "args": 1
            },
            "inputs": {
             "A0": {
              "block": {
               "type": "construct",
               "extraState": {
                "con": "Led1",
                "args": 1
               },
               "inputs": {
                "A0": {
                 "block": {
                  "type": "name",
                  "extraState": {
                   "name": "color",
                   "args": 0
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         },
         "next": {
          "block": {
           "type": "step_wait",
           "inputs": {
            "X": {
             "block": {
              "type": "number",
              "extraState": {
               "value": "0.5"
              }
             }
            }
           },
           "next": {
            "block": {
             "type": "step_do",
             "inputs": {
              "X": {
               "block": {
                "type": "name",
                "extraState": {
                 "name": "once",
                 "args": 1
                },
                "inputs": {
                 "A0": {
                  "block": {
                   "type": "construct",
                   "extraState": {
                    "con": "Led1",
                    "args": 1
                   },
                   "inputs": {
                    "A0": {
                     "block": {
                      "type": "choice",
                      "extraState": {
                       "of": "LedColor",
                       "value": "Black"
                      }
                     }
                    }
                   }
                  }
                 }
                }
               }
              }
             },
             "next": {
              "block": {
               "type": "step_wait",
               "inputs": {
                "X": {
                 "block": {
                  "type": "number",
                  "extraState": {
                   "value": "0.5"
                  }
                 }
                }
               }
              }
             }
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| Half a second of light in the first LED, half a second without."
    }
   }
  }
 },
 {
  "name": "beep",
  "block": {
   "type": "define",
   "extraState": {
    "name": "beep",
    "as": "task",
    "arity": 0,
    "equations": [
     {}
    ],
    "signature": "Task ()"
   },
   "inputs": {
    "E0_0": {
     "block": {
      "type": "infix",
      "extraState": {
       "op": ">>"
      },
      "inputs": {
       "L": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "once",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "choice",
            "extraState": {
             "of": "Sound",
             "value": "ButtonSound"
            }
           }
          }
         }
        }
       },
       "R": {
        "block": {
         "type": "name",
         "extraState": {
          "name": "wait",
          "args": 1
         },
         "inputs": {
          "A0": {
           "block": {
            "type": "number",
            "extraState": {
             "value": "0.5"
            }
           }
          }
         }
        }
       }
      }
     }
    }
   },
   "icons": {
    "comment": {
     "text": "| A short sound."
    }
   }
  }
 }
]
