package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.config.Place;
import org.dfra.river.bootstrap.RobotBootstrap.ServiceReference;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Starts a service that is registered, and says in the words of the robot's description why one did
 * not start.
 */
final class ServiceStart {

  private static final Logger LOG = LoggerFactory.getLogger(ServiceStart.class);

  /** How a group begins to tell that a constructor threw something. */
  private static final Pattern THROWN =
      Pattern.compile("[\\w.$]+: its constructor failed: [\\w.$]+(?:Exception|Error): ");

  /** How a group begins to tell that there is no such class. */
  private static final Pattern MISSING =
      Pattern.compile("([\\w.$]+): its class is not on the group's class path: ");

  private ServiceStart() {}

  /**
   * Activates a service; nothing happens where it runs.
   *
   * @param place where it is described
   * @param patience for phoenix's answer: on a busy computer a process takes long to start
   * @throws ActivationException if it did not start: where it is described, which it is, and why
   */
  static void activate(ServiceReference service, Place place, RetryDeadline patience)
      throws ActivationException, IOException {
    try {
      patience.call(() -> service.id().activate(false));
    } catch (ActivationException e) {
      // Without the cause: an activation exception's message repeats its cause's.
      String known = place + ": module " + service.name() + ": ";
      throw new ActivationException(
          place + ": " + service.name() + " did not start: " + reason(e).replace(known, ""));
    }
    LOG.info("{} is up in group {}.", service.name(), service.group());
  }

  /**
   * Why something did not start, without the names of the classes in which that happened; these are
   * in the group's log.
   */
  private static String reason(ActivationException failure) {
    String message = String.valueOf(failure.getMessage());
    Matcher missing = MISSING.matcher(message);
    if (missing.lookingAt()) {
      return "server class "
          + missing.group(1)
          + " is not on the group's class path; add its jar or mend the name";
    }
    Matcher thrown = THROWN.matcher(message);
    return thrown.lookingAt() ? message.substring(thrown.end()) : message;
  }
}
