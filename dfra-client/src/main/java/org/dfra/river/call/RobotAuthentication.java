package org.dfra.river.call;

import java.io.InvalidObjectException;
import java.rmi.Remote;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import org.dfra.river.identity.CurrentIdentity;

/** Who may answer the calls of a received proxy. */
public final class RobotAuthentication {

  private RobotAuthentication() {}

  /**
   * Lets only a robot's own processes answer, if this program has joined a team. Otherwise nobody
   * can be authenticated, and the proxy stays as it is.
   *
   * @param robot name of the robot that the proxy claims to be of
   * @param stub a remote proxy of JERI
   * @return the same, with a constraint on its server
   * @throws InvalidObjectException if no robot can have the name, or the server of such a proxy
   *     cannot be authenticated
   */
  public static <T extends Remote> T require(String robot, T stub) throws InvalidObjectException {
    InvocationConstraints required;
    try {
      required = CurrentIdentity.requiredOfRobot(robot);
    } catch (IllegalArgumentException e) { // no member has such a name
      throw (InvalidObjectException)
          new InvalidObjectException("a proxy of robot \"" + robot + "\"").initCause(e);
    }
    if (required.isEmpty()) {
      return stub;
    } else if (stub instanceof RemoteMethodControl controlled) {
      @SuppressWarnings("unchecked") // a copy of the same class
      T restricted = (T) controlled.setConstraints(new BasicMethodConstraints(required));
      return restricted;
    }
    throw new InvalidObjectException(
        "a proxy of robot " + robot + ", whose server nobody can authenticate");
  }
}
