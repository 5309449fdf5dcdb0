package org.dfra.geometry;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** Something that is somewhere: it has a frame, and stands in another one. */
public interface Posable {

  /** The name of its own frame, {@code robot/name}. */
  @Idempotent
  String frame() throws RemoteException;

  /** The name of the frame it stands in, such as {@code atrv1/base_link}. */
  @Idempotent
  String parentFrame() throws RemoteException;

  /**
   * Where its own frame stands in the parent frame now: takes coordinates in its own frame to
   * coordinates in the parent frame.
   */
  @Idempotent
  Transform localTransform() throws RemoteException;
}
