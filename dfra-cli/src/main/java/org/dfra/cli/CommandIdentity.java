package org.dfra.cli;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.news.NewsExchange;

/** The identity with which a command calls robots: that of its state folder. */
final class CommandIdentity {

  private static final String AUDIT = "audit";
  private static final Duration END_PATIENCE = Duration.ofMillis(500);

  /** These verbs call nobody, or start robots of their own, which are in no team. */
  private static final Set<String> WITHOUT =
      Set.of(
          "security",
          "whoami",
          "policy",
          AUDIT,
          "demo",
          "sim",
          "bench",
          "fuzzy",
          "completion",
          "help");

  /** Those of {@code security} that call robots. */
  private static final Set<String> SECURITY_WITH = Set.of("publish", "revoke");

  /** Stopping is safe: it also goes to robots whose certificate has expired. */
  private static final String STOP = "stop";

  private static final String FROM = "--from";
  private static final String OPTION = "--state";

  private CommandIdentity() {}

  /**
   * Installs it, before anything is called.
   *
   * @param args as they were typed
   * @param warning receives the reason if others do not believe it
   * @throws IllegalStateException if there is one that cannot be used
   */
  static void install(String[] args, Consumer<String> warning) {
    if (args.length > 0 && !args[0].startsWith("-") && callsRobots(args)) {
      SecureProcess.Installed own =
          SecureProcess.install(SecureProcess.folder(state(List.of(args))), args[0].equals(STOP));
      if (own.mode() == SecurityMode.CLOSED) {
        warning.accept(own.fault());
      }
    }
  }

  /**
   * Gives what the command has begun to exchange with other members a moment to arrive, after its
   * answer. A stop does not wait.
   *
   * @param args as they were typed
   */
  static void finish(String[] args) {
    Optional<NewsExchange> news = SecureProcess.news();
    if (news.isPresent() && args.length > 0 && !args[0].equals(STOP)) {
      try {
        news.get().awaitExchanges(END_PATIENCE);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt(); // it ends now
      }
    }
  }

  /** The audit trail is in files, but heads of it can be asked for. */
  private static boolean callsRobots(String[] args) {
    return !WITHOUT.contains(args[0])
        || (args[0].equals("security") && args.length > 1 && SECURITY_WITH.contains(args[1]))
        || (args[0].equals(AUDIT) && Arrays.stream(args).anyMatch(each -> each.startsWith(FROM)));
  }

  private static Path state(List<String> args) {
    for (int i = 0; i < args.size(); i++) {
      String each = args.get(i);
      if (each.startsWith(OPTION + "=")) {
        return Path.of(each.substring(OPTION.length() + 1)).toAbsolutePath();
      } else if (each.equals(OPTION) && i + 1 < args.size()) {
        return Path.of(args.get(i + 1)).toAbsolutePath();
      }
    }
    return StateOption.defaultFolder();
  }
}
