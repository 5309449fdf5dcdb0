package org.dfra.security;

import java.lang.reflect.Method;

/**
 * A call that is about to be made. Its arguments are not read yet.
 *
 * @param caller who makes it
 * @param robot the robot that the called object belongs to; empty if to none
 * @param object name of the called object, such as a module's {@code gps1}; empty if it has none
 * @param type class of the called object, or one of its interfaces if no more is known: a rule
 *     about drives needs it, since a drive has methods that each effector has
 * @param method the called method, as one of the object's interfaces declares it
 */
public record AccessRequest(
    Caller caller, String robot, String object, Class<?> type, Method method) {

  /**
   * A call of an object whose class is not known. It counts as an object of every interface that
   * has the method, where that leads to a refusal, and otherwise only of the interface that
   * declares it.
   */
  public AccessRequest(Caller caller, String robot, String object, Method method) {
    this(caller, robot, object, method.getDeclaringClass(), method);
  }

  /** The same call by another caller. */
  public AccessRequest by(Caller other) {
    return new AccessRequest(other, robot, object, type, method);
  }

  /** The method in sentences, such as {@code Effector.execute}. */
  public String methodName() {
    return method.getDeclaringClass().getSimpleName() + "." + method.getName();
  }
}
