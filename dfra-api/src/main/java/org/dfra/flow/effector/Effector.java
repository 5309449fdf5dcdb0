package org.dfra.flow.effector;

import java.rmi.RemoteException;
import java.time.Duration;
import org.dfra.flow.Device;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;
import org.dfra.module.StopsRobot;
import org.jspecify.annotations.Nullable;

/**
 * A module that acts on the world. It executes only its commander's commands, in its own virtual
 * machine as over the network, and stops when it has no commander.
 *
 * @param <C> its commands
 */
public interface Effector<C extends Command> extends Device {

  /**
   * Makes the caller the effector's commander until the lease is closed.
   *
   * @param duration the time after which the lease ends if its holder dies
   * @throws LeaseRefusedException if there is a commander already, or {@code duration} is longer
   *     than the module allows, or not above zero, or the effector is {@linkplain #emergencyStop
   *     stopped}
   */
  CommandLease acquireCommandLease(Duration duration) throws LeaseRefusedException, RemoteException;

  /**
   * Executes a command. Execution has begun when the call returns; a command is never repeated
   * automatically.
   *
   * @param key the key of the commander's lease
   * @throws CommandRefusedException if the key is not, or no longer, that of the commander, or the
   *     effector is {@linkplain #emergencyStop stopped}
   * @throws org.dfra.module.NotReadyException if the device is not ready
   */
  void execute(CommandKey key, C command) throws RemoteException;

  /**
   * Makes an emergency stop. Any client may request it: the commander loses its lease at once, the
   * device stops, and no client can command it until it is {@linkplain #releaseEmergencyStop
   * released}. The stop persists across restarts of the effector's virtual machine. It is never
   * refused, even while the module is not ready, and waits at most half a second for a driver that
   * blocks. A repeated stop stops the device again; the first requester is kept.
   *
   * @param requester the requester's name, for operators; any text is accepted, also null, and
   *     {@link EmergencyStopState#requesterName} of it is stored
   * @return the current state
   */
  @Idempotent
  @StopsRobot
  EmergencyStopState emergencyStop(@Nullable String requester) throws RemoteException;

  /**
   * Releases an emergency stop. The release moves nothing: a client must acquire a new lease to
   * command. Not declared idempotent, so that a failover proxy does not release another effector in
   * place of one that does not answer; a repeated call is harmless.
   *
   * @param requester the requester's name, for operators; as for {@link #emergencyStop}
   * @return the current state
   */
  @Administrative
  EmergencyStopState releaseEmergencyStop(@Nullable String requester) throws RemoteException;

  /** The emergency-stop state. */
  @Idempotent
  EmergencyStopState emergencyStopState() throws RemoteException;
}
