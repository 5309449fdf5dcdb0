package org.dfra.river.lookup;

import java.util.List;
import org.dfra.text.PrintableText;

/**
 * Lookup services list different services under one service ID. One of them may come from an
 * unknown registrant. A module that was just restarted causes the same for a moment.
 *
 * @param path {@code robot/name} of the module, or the robot's name, in the listing that takes
 *     precedence
 * @param id the service ID
 * @param preferred the lookup service that takes precedence, as {@code address:port}
 * @param others the lookup services that list something else
 */
public record ModuleConflict(String path, String id, String preferred, List<String> others) {

  public ModuleConflict {
    path = PrintableText.word(path);
    others = List.copyOf(others);
  }

  /** A sentence without a full stop: the conflict, its place, and the remedy. */
  public String describe() {
    return path
        + " is listed differently by the lookup services at "
        + preferred
        + ", which counts here, and "
        + String.join(", ", others)
        + "; if it was not restarted just now, find out whose those lookup services are";
  }
}
