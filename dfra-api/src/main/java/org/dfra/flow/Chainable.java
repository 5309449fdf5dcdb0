package org.dfra.flow;

import java.rmi.RemoteException;
import java.util.List;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;

/**
 * A link of a chain: what it takes in and what it puts out.
 *
 * <pre>
 *   atrv1/laser --LaserScan--&gt; atrv1/obstacles --ObstacleMap--&gt; atrv1/avoid
 *                              inputs  [atrv1/laser]
 *                              outputs [atrv1/avoid]
 * </pre>
 *
 * <p>Modules are named by their paths, {@code robot/name}, and what flows by the simple name of its
 * record's class. A chain can be set and set anew while it runs.
 */
public interface Chainable {

  /** The types it takes in, in the order of its inputs; none where it senses the world itself. */
  @Idempotent
  List<String> inputTypes() throws RemoteException;

  /** The types it puts out. */
  @Idempotent
  List<String> outputTypes() throws RemoteException;

  /** The modules it takes its input from; empty while it is not wired. */
  @Idempotent
  List<String> inputs() throws RemoteException;

  /** The modules that its output is for. */
  @Idempotent
  List<String> outputs() throws RemoteException;

  /**
   * Takes its input from these modules from now on, and from no others.
   *
   * @param modules as many as there are input types, or none
   * @throws IllegalArgumentException if there are more or fewer, or one is no module's path
   */
  @Administrative
  @Idempotent
  void setInputs(List<String> modules) throws RemoteException;

  /**
   * Puts its output out for these modules from now on.
   *
   * @throws IllegalArgumentException if one is no module's path, is named twice, or there is no
   *     output
   */
  @Administrative
  @Idempotent
  void setOutputs(List<String> modules) throws RemoteException;
}
