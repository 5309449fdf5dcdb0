package org.dfra.phoenix;

import java.rmi.Remote;
import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** What the tests' activatable objects do. */
public interface Beacon extends Remote {

  /** Number of the process that serves it. */
  @Idempotent
  long pid() throws RemoteException;

  /** Instances of the class made in this virtual machine so far. */
  @Idempotent
  int instances() throws RemoteException;

  /** Counts up; repeating it would do harm. */
  int count() throws RemoteException;

  /** Takes its time. */
  void sleep(long millis) throws RemoteException;

  /** Takes a load and says how much it was. */
  @Idempotent
  int length(byte[] load) throws RemoteException;

  /** Becomes inactive, in a moment and on a thread of its own. */
  void deactivate() throws RemoteException;

  /** Prints a line. */
  void print(String line) throws RemoteException;
}
