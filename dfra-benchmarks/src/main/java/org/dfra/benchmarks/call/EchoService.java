package org.dfra.benchmarks.call;

import java.rmi.Remote;
import java.rmi.RemoteException;

/** The remote object that is called: a small result and a larger one. */
public interface EchoService extends Remote {

  /** Number of values in the larger result: a SICK LMS 200 measures as many distances in a scan. */
  int VALUES = 361;

  /**
   * Returns its argument.
   *
   * @throws RemoteException if the call fails
   */
  long echo(long value) throws RemoteException;

  /**
   * Returns {@value #VALUES} numbers: {@link EchoServer#EXPECTED}.
   *
   * @throws RemoteException if the call fails
   */
  double[] values() throws RemoteException;
}
