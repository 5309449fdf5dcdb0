package org.dfra.cli.policy;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.NoSuchElementException;
import java.util.concurrent.Callable;
import org.dfra.core.config.NearestName;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyExplanation;
import org.dfra.core.policy.PolicyRule;
import org.dfra.core.policy.method.CalledMethod;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code ./dfra policy explain}. */
@Command(
    name = "explain",
    description =
        "Explains which rule of a policy decides about a call, and why no earlier one does; or what"
            + " a caller sees in lookup services.",
    footer = {
      "",
      "Exits with 0 whether the call is permitted or not, and with 3 if there is no such method or",
      "attribute."
    })
final class ExplainCommand implements Callable<Integer> {

  @Option(
      names = "--who",
      required = true,
      paramLabel = "CALLER",
      description =
          "A role and a name, such as \"operator anna\", \"expired operator anna\", stranger, or own"
              + " for a process of the same robot.")
  private String who = "";

  @Option(
      names = "--for",
      paramLabel = "CALLER",
      description = "On whose behalf it calls, such as \"operator anna\" (default: its own).")
  private @Nullable String behalf;

  @Option(
      names = "--what",
      required = true,
      paramLabel = "WHAT",
      description =
          "The called method, such as DriveEffector.execute; or \"entry module.host\" or \"entry module\""
              + " for attributes in a lookup service, or \"service\" for a service there. \"of GPSSensor\""
              + " after it says what the service is.")
  private String what = "";

  @Option(
      names = "--robot",
      paramLabel = "ROBOT",
      description = "The robot that the called object belongs to (default ${DEFAULT-VALUE}).")
  private String robot = "robot";

  @Option(
      names = "--object",
      paramLabel = "MODULE",
      description = "The called object, such as a module (default: one without a name).")
  private String object = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PolicyFile file;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  /** A rule in the command's output. */
  record RuleView(String name, String effect, String place, String reason) {

    static RuleView of(PolicyRule rule, String reason) {
      return new RuleView(rule.name(), rule.effect().text(), rule.place().toString(), reason);
    }
  }

  /** The command's output. */
  record ExplanationView(
      String outcome,
      String caller,
      String method,
      String kind,
      @Nullable RuleView rule,
      List<String> obligations,
      List<RuleView> conditional,
      List<RuleView> nearMisses,
      @Nullable ExplanationView principal) {}

  @Override
  public Integer call() {
    Policy policy = file.read();
    Caller caller = CallerArgument.parse(who, policy.team(), robot);
    if (SeenArgument.isSeen(what)) {
      ExplainedView seen = SeenArgument.parse(what, robot, object).explain(policy, caller);
      answer.lines(seen, seen.lines());
      return ExitCode.SUCCESS;
    }
    CalledMethod method = method(PolicyFile.catalogue());
    if (behalf == null || method.kind() == MethodKind.STOP) {
      PolicyExplanation explanation = PolicyExplanation.of(policy, caller, method, robot, object);
      ExplanationView view = view(caller, method, explanation, null);
      answer.lines(view, lines(view, explanation, policy));
    } else {
      explainBoth(policy, caller, CallerArgument.parse(behalf, policy.team(), robot), method);
    }
    return ExitCode.SUCCESS;
  }

  /** A call on somebody's behalf runs only if both are permitted. */
  private void explainBoth(Policy policy, Caller bearer, Caller principal, CalledMethod method) {
    Caller both;
    try {
      both = bearer.onBehalfOf(Behalf.of(principal.member().orElseThrow()));
    } catch (IllegalArgumentException | NoSuchElementException e) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR, "nobody calls for a stranger, and a stranger for nobody", e);
    }
    PolicyExplanation first = PolicyExplanation.of(policy, both, method, robot, object);
    PolicyExplanation second = PolicyExplanation.of(policy, principal, method, robot, object);
    ExplanationView principals = view(principal, method, second, null);
    ExplanationView view = view(both, method, first, principals);
    List<String> lines = new ArrayList<>();
    lines.add("A call on somebody's behalf must be permitted to both.");
    lines.addAll(lines(view, first, policy));
    lines.addAll(lines(principals, second, policy));
    answer.lines(view, lines);
  }

  private CalledMethod method(InterfaceCatalogue catalogue) {
    int dot = what.lastIndexOf('.');
    if (dot <= 0) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR,
          "--what \""
              + what
              + "\" is no method; write it as DriveEffector.execute, or \"entry module.host\"");
    }
    String type = what.substring(0, dot);
    List<CataloguedInterface> found = catalogue.named(type);
    if (found.size() != 1) {
      throw new CommandFailure(
          ExitCode.NOT_FOUND,
          "there is no remote interface \""
              + type
              + "\""
              + NearestName.hint(
                  type, catalogue.simpleNames(), "; write its full name, with its package"));
    }
    String name = what.substring(dot + 1);
    CataloguedInterface known = found.get(0);
    if (!known.methods().contains(name)) {
      throw new CommandFailure(
          ExitCode.NOT_FOUND,
          type
              + " has no method \""
              + name
              + "\""
              + NearestName.hint(
                  name, known.methods(), "; it has " + String.join(", ", known.methods())));
    }
    return CalledMethod.of(known, name, catalogue);
  }

  private ExplanationView view(
      Caller caller,
      CalledMethod method,
      PolicyExplanation found,
      @Nullable ExplanationView principal) {
    @Nullable PolicyRule deciding = found.deciding();
    List<RuleView> conditional = new ArrayList<>();
    found
        .conditional()
        .forEach(each -> conditional.add(RuleView.of(each, ifHolds(each, method.kind()))));
    List<RuleView> misses = new ArrayList<>();
    found.nearMisses().forEach(each -> misses.add(RuleView.of(each.rule(), each.reason())));
    return new ExplanationView(
        found.outcome().name().toLowerCase(Locale.ROOT),
        caller.member().map(Object::toString).orElse("stranger")
            + caller.behalf().map(each -> " for " + each).orElse(""),
        what,
        method.kind().text(),
        deciding == null ? null : RuleView.of(deciding, ""),
        deciding == null ? List.of() : deciding.obligations().of(method.kind()).inWords(),
        conditional,
        misses,
        principal);
  }

  private static String ifHolds(PolicyRule rule, MethodKind kind) {
    List<String> all = new ArrayList<>(rule.conditions());
    all.addAll(rule.obligations().of(kind).inWords());
    return String.join("; ", all);
  }

  private static List<String> lines(
      ExplanationView view, PolicyExplanation explanation, Policy policy) {
    List<String> lines = new ArrayList<>();
    String verdict =
        switch (explanation.outcome()) {
          case PERMIT -> "permitted";
          case DENY -> "refused";
          case DEPENDS -> "permitted or refused, which depends on what follows";
        };
    lines.add(view.method() + " (" + view.kind() + ") by " + view.caller() + ": " + verdict + ".");
    for (RuleView each : view.conditional()) {
      lines.add(
          "While its conditions hold, " + inWords(each) + " decides: only " + each.reason() + ".");
    }
    @Nullable RuleView rule = view.rule();
    String begin = view.conditional().isEmpty() ? "" : "Otherwise ";
    lines.add(
        rule == null
            ? begin + "no rule of " + policy + " matches, so the call is refused."
            : begin + inWords(rule) + " decides.");
    view.obligations().forEach(each -> lines.add("Obligation: " + each + "."));
    for (RuleView each : view.nearMisses()) {
      lines.add("Before it, " + inWords(each) + " does not match: " + each.reason() + ".");
    }
    return lines;
  }

  private static String inWords(RuleView rule) {
    return "<" + rule.effect() + "> " + rule.name() + " (" + rule.place() + ")";
  }
}
