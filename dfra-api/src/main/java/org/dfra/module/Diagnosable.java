package org.dfra.module;

import java.rmi.RemoteException;
import java.util.List;

/** Something that can examine itself and mend itself. */
public interface Diagnosable {

  /** What the environment must be like for it to work. */
  @Idempotent
  List<Precondition> preconditions() throws RemoteException;

  /** The names of the tests it knows. */
  @Idempotent
  List<String> tests() throws RemoteException;

  /**
   * Runs a test, on the real hardware.
   *
   * @throws IllegalArgumentException if it knows no such test; the message names those it knows
   */
  Diagnosis test(String name) throws RemoteException;

  /** The names of the recovery methods it knows. */
  @Idempotent
  List<String> recoveries() throws RemoteException;

  /**
   * Runs a recovery method. It is a command: it is never repeated by itself.
   *
   * @throws IllegalArgumentException if it knows no such method; the message names those it knows
   */
  Diagnosis recover(String name) throws RemoteException;
}
