package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.bootstrap.RobotBootstrap.ServiceReference;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Starts a registered service. If it does not start, reports the reason in terms of the robot's
 * description.
 */
final class ServiceStart {

  private static final Logger LOG = LoggerFactory.getLogger(ServiceStart.class);

  /**
   * The start of a group's report that a constructor, or the start after it, threw an exception.
   */
  private static final Pattern THROWN =
      Pattern.compile(
          "[\\w.$]+: (?:its constructor failed|it did not start): [\\w.$]+(?:Exception|Error): ");

  /** The start of a group's report that a class is missing. */
  private static final Pattern MISSING =
      Pattern.compile("([\\w.$]+): its class is not on the group's class path: ");

  private ServiceStart() {}

  /**
   * Activates a service; does nothing if it runs.
   *
   * @param place the place of its description
   * @param patience limits the retries: on a busy computer a process takes long to start
   * @throws ActivationException if it did not start; the message names the service, the place of
   *     its description and the reason
   */
  static void activate(ServiceReference service, SourceLocation place, RetryDeadline patience)
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
   * The reason why a service did not start, without the names of the classes in which the error
   * occurred; these are in the group's log.
   */
  private static String reason(ActivationException failure) {
    String message = String.valueOf(failure.getMessage());
    Matcher missing = MISSING.matcher(message);
    if (missing.lookingAt()) {
      return "server class "
          + missing.group(1)
          + " is not on the group's class path; add its jar or correct the name";
    }
    Matcher thrown = THROWN.matcher(message);
    return thrown.lookingAt() ? message.substring(thrown.end()) : message;
  }
}
