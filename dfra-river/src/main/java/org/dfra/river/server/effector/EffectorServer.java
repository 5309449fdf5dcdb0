package org.dfra.river.server.effector;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.UUID;
import net.jini.core.lease.Lease;
import org.dfra.core.effector.CommandArbiter;
import org.dfra.core.effector.EffectorImpl;
import org.dfra.flow.effector.Command;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.Effector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.phoenix.stop.StopTargetRegistry.StopTarget;
import org.dfra.river.remote.GrantedModuleLease;
import org.dfra.river.remote.effector.GrantedCommandLease;
import org.dfra.river.remote.effector.RemoteEffector;
import org.dfra.river.server.DeviceServer;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of an effector. The driver's {@link CommandArbiter} decides whether a command
 * is executed.
 *
 * @param <C> the effector's command type
 * @param <E> the effector's interface
 */
public abstract class EffectorServer<C extends Command, E extends Effector<C>>
    extends DeviceServer<E> implements RemoteEffector<C>, StopTarget {

  /** See {@link ModuleServer#ModuleServer}. */
  protected EffectorServer(
      Class<E> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, EffectorImpl.class, id, data); // only this class guards the effector
  }

  private CommandArbiter arbiter() {
    return ((EffectorImpl<?>) module()).commandArbiter();
  }

  @Override
  public final UUID moduleId() {
    return id();
  }

  @Override
  public final String modulePath() {
    return path();
  }

  @Override
  public final CommandLease acquireCommandLease(Duration duration) throws LeaseRefusedException {
    Lease[] lease = new Lease[1];
    CommandKey key =
        arbiter()
            .acquire(
                clientName(),
                whenOver -> {
                  lease[0] = grant(duration, LeaseRole.COMMANDER, whenOver, whenOver);
                  return ModuleLandlord.id(lease[0]);
                });
    return new GrantedCommandLease(new GrantedModuleLease(lease[0]), key);
  }

  @Override
  public final void execute(CommandKey key, C command) throws RemoteException {
    module().execute(key, command);
  }

  @Override
  public final EmergencyStopState emergencyStop(@Nullable String by) throws RemoteException {
    return module().emergencyStop(by);
  }

  @Override
  public final EmergencyStopState releaseEmergencyStop(@Nullable String by) throws RemoteException {
    return module().releaseEmergencyStop(by);
  }

  @Override
  public final EmergencyStopState emergencyStopState() throws RemoteException {
    return module().emergencyStopState();
  }
}
