package org.dfra.cli.policy;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dfra.core.config.NearestName;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyVisibility;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.security.Caller;
import org.dfra.security.Visibility.ListedService;

/**
 * Parses what a caller may see: {@code service}, {@code service of GPSSensor}, {@code entry
 * module.host}, {@code entry module of GPSSensor}.
 *
 * @param entry empty for the service itself
 */
record SeenArgument(String text, ListedService service, String entry) {

  private static final String SERVICE = "service";
  private static final String ENTRY = "entry";

  /** Whether a text is about what is seen, and not about a call. */
  static boolean isSeen(String text) {
    String first = text.strip().split("\\s+")[0];
    return first.equals(SERVICE) || first.equals(ENTRY);
  }

  /**
   * What is seen.
   *
   * @param robot that the service belongs to
   * @param object name of its module; empty for none
   * @throws CommandFailure if the text has another form, or names no interface
   */
  static SeenArgument parse(String text, String robot, String object) {
    List<String> words = new ArrayList<>(List.of(text.strip().split("\\s+")));
    boolean isEntry = words.remove(0).equals(ENTRY);
    String entry = isEntry && !words.isEmpty() ? words.remove(0) : "";
    Set<String> types = new HashSet<>();
    if (words.size() == 2 && words.get(0).equals("of")) {
      CataloguedInterface type = type(words.get(1));
      types.add(type.name());
      types.addAll(type.superinterfaces());
      words.clear();
    }
    if (!words.isEmpty() || isEntry == entry.isEmpty()) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR,
          "--what \""
              + text
              + "\" is nothing that is seen; write \"entry module.host\", \"entry module of"
              + " GPSSensor\" or \"service of GPSSensor\"");
    }
    return new SeenArgument(text.strip(), new ListedService(robot, object, types), entry);
  }

  private static CataloguedInterface type(String name) {
    InterfaceCatalogue catalogue = PolicyFile.catalogue();
    List<CataloguedInterface> found = catalogue.named(name);
    if (found.size() != 1) {
      throw new CommandFailure(
          ExitCode.NOT_FOUND,
          "there is no remote interface \""
              + name
              + "\""
              + NearestName.hint(
                  name, catalogue.simpleNames(), "; write its full name, with its package"));
    }
    return found.get(0);
  }

  /**
   * What a policy shows of it.
   *
   * @throws CommandFailure if there are no such attributes
   */
  ExplainedView explain(Policy policy, Caller caller) {
    try {
      return ExplainedView.of(
          text, policy, caller, PolicyVisibility.explain(policy, caller, service, entry));
    } catch (IllegalArgumentException e) {
      throw new CommandFailure(ExitCode.NOT_FOUND, String.valueOf(e.getMessage()), e);
    }
  }
}
