package org.dfra.security;

import java.lang.reflect.Method;

/**
 * A call that is about to be made. Its arguments are not read yet.
 *
 * @param caller who makes it
 * @param robot the robot that the called object belongs to; empty if to none
 * @param object name of the called object, such as a module's {@code gps1}; empty if it has none
 * @param method the called method, as one of the object's interfaces declares it
 */
public record AccessRequest(Caller caller, String robot, String object, Method method) {

  /** The method in sentences, such as {@code DriveEffector.setVelocity}. */
  public String methodName() {
    return method.getDeclaringClass().getSimpleName() + "." + method.getName();
  }
}
