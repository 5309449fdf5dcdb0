package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;

/** Whether the daemon runs or is shutting down. It never runs again. */
final class DaemonState {

  private volatile boolean running = true;

  /** Whether the daemon is not shutting down. */
  boolean isRunning() {
    return running;
  }

  /**
   * Refuses new work while the daemon shuts down.
   *
   * @throws ActivationException if it does
   */
  void requireRunning() throws ActivationException {
    if (!running) {
      throw new ActivationException("phoenix is shutting down; call again when it has restarted");
    }
  }

  /** Records that the daemon is shutting down. */
  void setEnding() {
    running = false;
  }
}
