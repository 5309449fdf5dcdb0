package org.dfra.benchmarks.micro;

import java.rmi.Remote;
import java.rmi.RemoteException;

/** The remote object of {@link CallBenchmark}: a small and a large result. */
public interface RangeSource extends Remote {

  /**
   * One distance, metres.
   *
   * @throws RemoteException if the call fails
   */
  double range() throws RemoteException;

  /**
   * The distances of a scan of 180° in steps of 0.5°, metres: 361 of them, as a SICK LMS 200 has.
   *
   * @throws RemoteException if the call fails
   */
  double[] scan() throws RemoteException;
}
