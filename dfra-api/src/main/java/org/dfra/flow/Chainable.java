package org.dfra.flow;

import java.rmi.RemoteException;
import java.util.List;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;

/**
 * A module in a processing chain: its inputs and outputs.
 *
 * <pre>
 *   atrv1/laser --LaserScan--&gt; atrv1/obstacles --ObstacleMap--&gt; atrv1/avoid
 *                              inputs  [atrv1/laser]
 *                              outputs [atrv1/avoid]
 * </pre>
 *
 * <p>Modules are named by their paths, {@code robot/name}, and what flows by the simple name of its
 * record's class. A chain can be configured and reconfigured while it runs.
 */
public interface Chainable {

  /** The input types, in the order of its inputs; empty if it senses the world itself. */
  @Idempotent
  List<String> inputTypes() throws RemoteException;

  /** The output types. */
  @Idempotent
  List<String> outputTypes() throws RemoteException;

  /** The modules that provide its input; empty while it is not wired. */
  @Idempotent
  List<String> inputs() throws RemoteException;

  /** The modules that receive its output. */
  @Idempotent
  List<String> outputs() throws RemoteException;

  /**
   * Replaces its input modules.
   *
   * @param modules as many as there are input types, or none
   * @throws IllegalArgumentException if there are more or fewer, or one is not a module's path
   */
  @Administrative
  @Idempotent
  void setInputs(List<String> modules) throws RemoteException;

  /**
   * Replaces its output modules.
   *
   * @throws IllegalArgumentException if one is not a module's path, is named twice, or the module
   *     has no output
   */
  @Administrative
  @Idempotent
  void setOutputs(List<String> modules) throws RemoteException;
}
