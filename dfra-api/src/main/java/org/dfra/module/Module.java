package org.dfra.module;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;

/**
 * A part of a robot that others can find, use and replace: a sensor, an effector, a schema, a
 * behaviour, a manager or an agent.
 *
 * <p>The first of the five classes of the module pattern. Local and remote callers use the same
 * methods, so each one declares {@link RemoteException}; it is never thrown to a caller in the
 * module's own virtual machine.
 */
public interface Module {

  /**
   * The module's identification. Constant during the module's lifetime, so proxies may cache it.
   */
  @Idempotent
  Identification identification() throws RemoteException;

  /** The state the module is in at the time of the call. */
  @Idempotent
  Readiness readiness() throws RemoteException;

  /**
   * Waits until the module {@linkplain Readiness#serves() serves} or can no longer reach that
   * state, for {@code timeout} at most.
   *
   * @param timeout longest wait, not negative
   * @return the state at the end of the wait; it serves, it has failed or stopped, or the timeout
   *     has passed
   */
  @Idempotent
  Readiness awaitReadiness(Duration timeout) throws RemoteException;

  /**
   * Subscribes to the module's events until the subscription is closed. A listener to readings
   * counts as a client of the module, as if it held a lease; a listener to other kinds of events
   * only observes.
   *
   * @param listener receives one event at a time
   * @param policy which events the listener receives, and how many are queued
   */
  Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) throws RemoteException;

  /**
   * Counts the caller as a client until the lease is closed. A module without clients may idle.
   *
   * @param duration the time after which the lease ends if its holder dies
   * @throws LeaseRefusedException if {@code duration} is longer than the module allows, or not
   *     above zero
   */
  ModuleLease acquireLease(Duration duration) throws LeaseRefusedException, RemoteException;

  /** The module's history. */
  @Idempotent
  ModuleHistory history() throws RemoteException;

  /** The module's log level. */
  @Idempotent
  LogLevel logLevel() throws RemoteException;

  /** Sets the module's log level. */
  @Administrative
  @Idempotent
  void setLogLevel(LogLevel level) throws RemoteException;

  /** Its current parameters, in alphabetical order. */
  @Idempotent
  List<Parameter> parameters() throws RemoteException;

  /**
   * Sets a parameter while the module runs.
   *
   * @throws IllegalArgumentException if there is no such parameter, it cannot be set now, or the
   *     text is not a valid value; the message names valid values
   */
  @Administrative
  @Idempotent
  void setParameter(String name, String text) throws RemoteException;
}
