package org.dfra.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.dfra.cli.audit.AuditCommand;
import org.dfra.cli.completion.CompletionCommand;
import org.dfra.cli.completion.ScriptVerbs;
import org.dfra.cli.doctor.DoctorCommand;
import org.dfra.cli.event.EventCommand;
import org.dfra.cli.lease.LeaseCommand;
import org.dfra.cli.log.LogCommand;
import org.dfra.cli.log.LogbackSetup;
import org.dfra.cli.log.PrintableTrace;
import org.dfra.cli.module.ModuleCommand;
import org.dfra.cli.persona.PersonaCommand;
import org.dfra.cli.policy.PolicyCommand;
import org.dfra.cli.recruit.RecruitCommand;
import org.dfra.cli.robot.DownCommand;
import org.dfra.cli.robot.StatusCommand;
import org.dfra.cli.robot.UpCommand;
import org.dfra.cli.security.SecurityCommand;
import org.dfra.cli.security.WhoamiCommand;
import org.dfra.cli.stop.StopCommand;
import org.dfra.cli.task.TaskCommand;
import org.dfra.core.config.RenamedNames;
import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ConsoleMessages;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.StatusHighlighter;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.BootClassPath;
import org.dfra.river.loading.TrustedCode;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;
import org.slf4j.bridge.SLF4JBridgeHandler;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Unmatched;

/** The command line {@code ./dfra}. */
@Command(
    name = "dfra",
    description = "The Distributed Field Robot Architecture.",
    versionProvider = Main.BuildVersion.class,
    mixinStandardHelpOptions = true,
    scope = ScopeType.INHERIT,
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n")
public final class Main {

  /** In the order in which the help lists them; other modules provide some of them. */
  private static final List<String> VERBS =
      List.of(
          "up",
          "down",
          "status",
          "stop",
          "doctor",
          "task",
          "module",
          "persona",
          "event",
          "lease",
          "log",
          "security",
          "whoami",
          "policy",
          "audit",
          "fuzzy",
          "recruit",
          "demo",
          "sim",
          "bench",
          "completion",
          "help");

  /** These commands need the full list of subcommands. */
  private static final Set<String> NEED_ALL_COMMANDS = Set.of("completion", "help");

  private Main() {}

  /** The version that the build wrote into the jar. */
  static final class BuildVersion implements IVersionProvider {
    @Override
    public String[] getVersion() {
      @Nullable String version = Main.class.getPackage().getImplementationVersion();
      return new String[] {"dfra " + (version == null ? "of a build without a jar" : version)};
    }
  }

  /** The command line when a subcommand is named: loading all subcommands takes 0.2 s. */
  @Command(
      name = "dfra",
      versionProvider = BuildVersion.class,
      mixinStandardHelpOptions = true,
      scope = ScopeType.INHERIT)
  private static final class OneVerb {}

  /** Runs the subcommand and exits with its status: 0 success, 1 failure, 2 usage error. */
  public static void main(String[] args) {
    SerialFilters.install(); // before any untrusted text is read
    if (System.getenv(LogbackSetup.LEVEL) == null
        && System.getProperty(LogbackSetup.LEVEL) == null) {
      System.setProperty(LogbackSetup.LEVEL, "WARN"); // standard output is reserved for results
      LogLevelControl.service()
          .set(TrustedCode.class.getPackageName(), LogLevel.ERROR); // commands report them
    }
    SLF4JBridgeHandler.removeHandlersForRootLogger();
    SLF4JBridgeHandler.install();
    RenamedNames.onWarning(each -> System.err.println(ConsoleMessages.prefixed(each)));
    Thread.setDefaultUncaughtExceptionHandler(Main::report);
    try {
      BootClassPath.require();
      TrustedCode.install();
    } catch (IOException | IllegalStateException e) {
      System.err.println(ConsoleMessages.prefixed(String.valueOf(e.getMessage())));
      System.exit(1);
    }
    try {
      CommandIdentity.install(args, each -> System.err.println(ConsoleMessages.prefixed(each)));
    } catch (IllegalStateException e) {
      System.err.println(ConsoleMessages.prefixed(String.valueOf(e.getMessage())));
      System.exit(1);
    }
    int status = commandLine(args).execute(args);
    CommandIdentity.finish(args);
    System.exit(status);
  }

  /** For example an error thrown by a proxy, whose code another computer supplies. */
  private static void report(Thread thread, Throwable thrown) {
    String name = PrintableText.name(thread.getName());
    System.err.print("Thread " + name + ": " + PrintableTrace.of(thrown));
  }

  /** The full command line, for commands that inspect it. */
  public static CommandLine commandLine() {
    CommandLine line = new CommandLine(new Main());
    ProvidedCommands provided = ProvidedCommands.installed();
    VERBS.forEach(verb -> add(verb, provided, line));
    provided.words().stream()
        .filter(words -> words.indexOf(' ') < 0 && !VERBS.contains(words))
        .forEach(verb -> add(verb, provided, line));
    line.getCommandSpec().usageMessage().footer(ScriptVerbs.help()); // not inherited by subcommands
    return prepared(line);
  }

  private static void add(String verb, ProvidedCommands provided, CommandLine line) {
    own(verb)
        .or(() -> provided.find(verb))
        .ifPresent(
            found -> {
              CommandLine added = new CommandLine(found);
              line.addSubcommand(added);
              provided.extend(verb, added);
            });
  }

  /**
   * The command line for the given arguments; it has all subcommands only if more than one is
   * needed.
   */
  public static CommandLine commandLine(String[] args) {
    if (args.length == 0 || NEED_ALL_COMMANDS.contains(args[0])) {
      return commandLine();
    }
    String verb = args[0];
    CommandLine line = new CommandLine(new OneVerb());
    Optional<Class<?>> own = own(verb);
    if (own.isPresent() && !ProvidedCommands.mayExtend(verb)) {
      line.addSubcommand(own.get());
      return prepared(line);
    }
    ProvidedCommands provided = ProvidedCommands.installed(); // opens all jars
    Optional<String> missing = provided.missing(args);
    if (missing.isPresent()) {
      return prepared(new CommandLine(new MissingCommand(missing.get())));
    }
    add(verb, provided, line);
    return line.getSubcommands().isEmpty() ? commandLine() : prepared(line);
  }

  /** The class of a subcommand of this module; loads no other one. */
  private static Optional<Class<?>> own(String verb) {
    return Optional.ofNullable(
        switch (verb) {
          case "up" -> UpCommand.class;
          case "down" -> DownCommand.class;
          case "status" -> StatusCommand.class;
          case "stop" -> StopCommand.class;
          case "doctor" -> DoctorCommand.class;
          case "task" -> TaskCommand.class;
          case "module" -> ModuleCommand.class;
          case "persona" -> PersonaCommand.class;
          case "event" -> EventCommand.class;
          case "lease" -> LeaseCommand.class;
          case "log" -> LogCommand.class;
          case "security" -> SecurityCommand.class;
          case "whoami" -> WhoamiCommand.class;
          case "policy" -> PolicyCommand.class;
          case "audit" -> AuditCommand.class;
          case "recruit" -> RecruitCommand.class;
          case "completion" -> CompletionCommand.class;
          case "help" -> HelpCommand.class;
          default -> null;
        });
  }

  private static CommandLine prepared(CommandLine line) {
    line.setCaseInsensitiveEnumValuesAllowed(true);
    line.setColorScheme(
        CommandLine.Help.defaultColorScheme(
            StatusHighlighter.isEnabled()
                ? CommandLine.Help.Ansi.AUTO
                : CommandLine.Help.Ansi.OFF));
    line.setHelpFactory(FoldedHelp::new);
    line.setParameterExceptionHandler(new UsageErrorHandler());
    line.setExecutionExceptionHandler(new CommandExceptionHandler());
    return line;
  }

  /** Stands for a command of a module that is not installed, with any arguments: it only fails. */
  @Command(name = "dfra")
  static final class MissingCommand implements Callable<Integer> {

    private final String sentence;

    @Unmatched
    @SuppressWarnings("UnusedVariable") // set by picocli
    private List<String> arguments = new ArrayList<>();

    /**
     * @param sentence which module is missing
     */
    MissingCommand(String sentence) {
      this.sentence = sentence;
    }

    @Override
    public Integer call() {
      throw new CommandFailure(ExitCode.NOT_INSTALLED, sentence);
    }
  }
}
