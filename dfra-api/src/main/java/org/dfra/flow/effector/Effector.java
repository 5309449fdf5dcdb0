package org.dfra.flow.effector;

import java.rmi.RemoteException;
import java.time.Duration;
import org.dfra.flow.Device;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * A module that acts on the world. It obeys its commander and nobody else, in its own virtual
 * machine as over the network, and comes to rest when there is none.
 *
 * @param <C> what it can be told
 */
public interface Effector<C extends Command> extends Device {

  /**
   * Makes the caller the effector's commander until the lease is closed.
   *
   * @param duration after which the lease ends if its holder dies
   * @throws LeaseRefusedException if there is a commander already, or {@code duration} is longer
   *     than the module allows, or not above zero, or the effector is {@linkplain #emergencyStop
   *     stopped}
   */
  CommandLease acquireCommandLease(Duration duration) throws LeaseRefusedException, RemoteException;

  /**
   * Tells the effector what to do. It has begun to when the call returns; it is never told twice by
   * itself.
   *
   * @param key of the commander's lease
   * @throws CommandRefusedException if the key is not, or no longer, that of the commander, or the
   *     effector is {@linkplain #emergencyStop stopped}
   * @throws org.dfra.module.NotReadyException if the device does not serve
   */
  void execute(CommandKey key, C command) throws RemoteException;

  /**
   * Stops the effector for an emergency, whoever asks and whoever commands: its commander loses the
   * command at once, the device comes to rest, and nobody can command it until it is {@linkplain
   * #releaseEmergencyStop released}. That outlives the effector's virtual machine. It is never
   * refused, also while the module does not serve, and does not wait longer than half a second for
   * a driver that is held up. Stopping it once more has it come to rest once more; who stopped it
   * first is kept.
   *
   * @param requester who asks, for people; any text will do, also none, and {@link
   *     EmergencyStopState#requesterName} is kept of it
   * @return how it is now
   */
  @Idempotent
  EmergencyStopState emergencyStop(@Nullable String requester) throws RemoteException;

  /**
   * Ends an emergency stop. Nothing moves by this: whoever wants to command asks for a new lease.
   * Not idempotent, so that no other effector is released in place of one that does not answer;
   * repeating it does no harm.
   *
   * @param requester who releases it, for people; as for {@link #emergencyStop}
   * @return how it is now
   */
  @Administrative
  EmergencyStopState releaseEmergencyStop(@Nullable String requester) throws RemoteException;

  /** Whether it is stopped for an emergency. */
  @Idempotent
  EmergencyStopState emergencyStopState() throws RemoteException;
}
