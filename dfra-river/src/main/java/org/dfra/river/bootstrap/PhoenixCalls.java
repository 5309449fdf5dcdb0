package org.dfra.river.bootstrap;

import java.rmi.activation.ActivationSystem;
import org.dfra.river.phoenix.PhoenixAdmin;

/**
 * Phoenix as the bootstrap calls it; one proxy implements both.
 *
 * @param system registers and unregisters
 * @param admin says what is registered and what runs
 */
record PhoenixCalls(ActivationSystem system, PhoenixAdmin admin) {

  /** Nothing is sent before the first call. */
  static PhoenixCalls to(PhoenixProcess phoenix) {
    return new PhoenixCalls(phoenix.system(), phoenix.admin());
  }
}
