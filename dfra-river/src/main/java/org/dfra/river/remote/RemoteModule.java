package org.dfra.river.remote;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import net.jini.admin.Administrable;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseDeniedException;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;
import org.dfra.module.Readiness;

/** What clients may call on any module's server. */
public interface RemoteModule extends Module, Remote, Administrable {

  /** The longest that one call waits at the server; proxies wait longer in several calls. */
  Duration LONGEST_WAIT = Duration.ofSeconds(1);

  /**
   * {@inheritDoc}
   *
   * <p>One call waits {@link #LONGEST_WAIT} at the longest, so that it ends before its deadline.
   */
  @Override
  @Idempotent
  Readiness awaitReadiness(Duration patience) throws RemoteException;

  /**
   * Counts the caller as a client of the module for a while.
   *
   * @param duration how long, in milliseconds
   * @return the lease, which can be renewed and cancelled
   * @throws LeaseDeniedException if {@code duration} is longer than the module allows
   */
  Lease use(long duration) throws LeaseDeniedException, RemoteException;
}
