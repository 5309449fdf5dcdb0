package org.dfra.river.lookup;

import java.util.List;
import org.dfra.text.PrintableText;

/**
 * Lookup services list different things under one service ID. One of them may be a stranger's; a
 * module that was just restarted looks the same for a moment.
 *
 * @param path {@code robot/name} of the module, or the robot's name, as the one that counts says
 * @param id the service ID
 * @param preferred where the lookup service is that counts, as {@code address:port}
 * @param others where those are that list something else
 */
public record ModuleConflict(String path, String id, String preferred, List<String> others) {

  public ModuleConflict {
    path = PrintableText.word(path);
    others = List.copyOf(others);
  }

  /** A sentence without a full stop: what, where, and what to do. */
  public String describe() {
    return path
        + " is listed differently by the lookup services at "
        + preferred
        + ", which counts here, and "
        + String.join(", ", others)
        + "; if it was not restarted just now, find out whose those lookup services are";
  }
}
