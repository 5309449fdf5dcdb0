package org.dfra.river.remote;

import com.sun.jini.admin.DestroyAdmin;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Instant;
import net.jini.admin.JoinAdmin;
import org.dfra.module.Idempotent;

/**
 * What administrators may do to a module while it runs: have it join other lookup services, add
 * entries to its own, and end it. A module's server gives it as its {@code getAdmin()}.
 */
public interface ModuleAdmin extends JoinAdmin, DestroyAdmin, Remote {

  /**
   * Ends the module until it is called again: it leaves the lookup services, closes its device and
   * tells the activation system, which then starts it as it is described by then. Returns when that
   * is done.
   */
  void deactivate() throws RemoteException;

  /**
   * The time by the clock of the module's host, for those who compare clocks.
   *
   * @return UTC
   */
  @Idempotent
  Instant clock() throws RemoteException;

  /**
   * {@inheritDoc}
   *
   * <p>As {@link #deactivate}, and the activation system forgets the module before. Returns when
   * that is done.
   */
  @Override
  void destroy() throws RemoteException;
}
