package org.dfra.geometry;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** An object with a pose: it has a frame, which is placed in a parent frame. */
public interface Posable {

  /** The name of its own frame, {@code robot/name}. */
  @Idempotent
  String frame() throws RemoteException;

  /** The name of the parent frame, such as {@code atrv1/base_link}. */
  @Idempotent
  String parentFrame() throws RemoteException;

  /**
   * The current pose of its own frame in the parent frame: maps coordinates in its own frame to
   * coordinates in the parent frame.
   */
  @Idempotent
  Transform localTransform() throws RemoteException;
}
