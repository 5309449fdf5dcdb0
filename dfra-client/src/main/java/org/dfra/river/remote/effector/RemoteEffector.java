package org.dfra.river.remote.effector;

import java.rmi.RemoteException;
import java.time.Duration;
import org.dfra.flow.effector.Command;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.Effector;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.river.remote.RemoteDevice;

/**
 * What clients may call on any effector's server.
 *
 * @param <C> its command type
 */
public interface RemoteEffector<C extends Command> extends RemoteDevice, Effector<C> {

  /**
   * {@inheritDoc}
   *
   * @return a {@link GrantedCommandLease}
   */
  @Override
  CommandLease acquireCommandLease(Duration duration) throws LeaseRefusedException, RemoteException;
}
