package org.dfra.module;

import java.rmi.RemoteException;
import java.time.Duration;

/**
 * A part of a robot that others can find, use and replace: a sensor, an effector, a schema, a
 * behaviour, a manager or an agent.
 *
 * <p>The first of the five classes of the module pattern. Local and remote callers use the same
 * methods, so each one declares {@link RemoteException}; a caller in the module's own virtual
 * machine never sees it thrown.
 */
public interface Module {

  /** Who this module is. Constant while the module lives, so proxies may cache it. */
  @Idempotent
  Identification identification() throws RemoteException;

  /** The state the module is in at the time of the call. */
  @Idempotent
  Readiness readiness() throws RemoteException;

  /**
   * Waits until the module {@linkplain Readiness#serves() serves} or can no longer come to serve,
   * at the longest for {@code patience}.
   *
   * @param patience longest wait, not negative
   * @return the state at the end of the wait; it serves, it has failed or stopped, or the patience
   *     is used up
   */
  @Idempotent
  Readiness awaitReadiness(Duration patience) throws RemoteException;
}
