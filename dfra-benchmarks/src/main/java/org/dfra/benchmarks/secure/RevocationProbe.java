package org.dfra.benchmarks.secure;

import java.rmi.Remote;
import java.rmi.RemoteException;
import net.jini.core.lease.Lease;
import org.dfra.lease.LeaseRefusedException;

/** What a member calls until it is revoked. */
public interface RevocationProbe extends Remote {

  /** Answers. */
  boolean answer() throws RemoteException;

  /** Grants the caller a lease. */
  Lease hold() throws RemoteException, LeaseRefusedException;
}
