package org.dfra.module;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;

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
   * @param timeout longest wait, not negative
   * @return the state at the end of the wait; it serves, it has failed or stopped, or the patience
   *     is used up
   */
  @Idempotent
  Readiness awaitReadiness(Duration timeout) throws RemoteException;

  /**
   * Listens to the module until the subscription is closed. Who listens to readings is a client of
   * the module, as if it held a lease; who listens to the other kinds of events only watches.
   *
   * @param listener is told one event at a time
   * @param policy what the listener can take
   */
  Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) throws RemoteException;

  /**
   * Counts the caller as a client until the lease is closed. A module without clients may rest.
   *
   * @param duration after which the lease ends if its holder dies
   * @throws LeaseRefusedException if {@code duration} is longer than the module allows, or not
   *     above zero
   */
  ModuleLease acquireLease(Duration duration) throws LeaseRefusedException, RemoteException;

  /** The module's life so far. */
  @Idempotent
  ModuleHistory history() throws RemoteException;

  /** How much the module writes to its log. */
  @Idempotent
  LogLevel logLevel() throws RemoteException;

  /** Sets how much the module writes to its log, from now on. */
  @Administrative
  @Idempotent
  void setLogLevel(LogLevel level) throws RemoteException;

  /** Its parameters as they are set now, in alphabetical order. */
  @Idempotent
  List<Parameter> parameters() throws RemoteException;

  /**
   * Sets a parameter while the module runs.
   *
   * @throws IllegalArgumentException if there is no such parameter, it cannot be set now, or the
   *     text is no value of it; the message says what would be
   */
  @Administrative
  @Idempotent
  void setParameter(String name, String text) throws RemoteException;
}
