package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;

/** The group has no object left and instantiates none; the daemon starts the next incarnation. */
final class InactiveGroupException extends ActivationException {

  private static final long serialVersionUID = 1L;

  InactiveGroupException(String message) {
    super(message);
  }
}
