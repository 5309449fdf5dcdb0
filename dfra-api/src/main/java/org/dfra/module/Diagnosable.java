package org.dfra.module;

import java.rmi.RemoteException;
import java.util.List;

/** A device that can diagnose and recover itself. */
public interface Diagnosable {

  /** The conditions of the environment that it needs to work. */
  @Idempotent
  List<Precondition> preconditions() throws RemoteException;

  /** The names of its tests. */
  @Idempotent
  List<String> tests() throws RemoteException;

  /**
   * Runs a test, on the real hardware.
   *
   * @throws IllegalArgumentException if there is no such test; the message lists the tests
   */
  Diagnosis test(String name) throws RemoteException;

  /** The names of its recovery methods. */
  @Idempotent
  List<String> recoveries() throws RemoteException;

  /**
   * Runs a recovery method. It is a command: it is never repeated automatically.
   *
   * @throws IllegalArgumentException if there is no such method; the message lists the methods
   */
  Diagnosis recover(String name) throws RemoteException;
}
