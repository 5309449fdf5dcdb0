package org.dfra.river.access;

/** A remote object that policies can name. */
public interface GuardedObject {

  /** Its name in policies and refusals, such as a module's {@code gps1}. It must not wait. */
  String guardedName();
}
