package org.dfra.app;

import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import org.dfra.app.benchmark.BenchCommand;
import org.dfra.app.completion.CompletionCommand;
import org.dfra.app.demo.DemoCommand;
import org.dfra.app.doctor.DoctorCommand;
import org.dfra.app.event.EventCommand;
import org.dfra.app.fuzzy.FuzzyCommand;
import org.dfra.app.lease.LeaseCommand;
import org.dfra.app.log.LogCommand;
import org.dfra.app.log.LogbackSetup;
import org.dfra.app.log.PrintableTrace;
import org.dfra.app.module.ModuleCommand;
import org.dfra.app.persona.PersonaCommand;
import org.dfra.app.recruit.RecruitCommand;
import org.dfra.app.robot.DownCommand;
import org.dfra.app.robot.StatusCommand;
import org.dfra.app.robot.UpCommand;
import org.dfra.app.sim.SimCommand;
import org.dfra.app.stop.StopCommand;
import org.dfra.app.task.TaskCommand;
import org.dfra.app.terminal.CommandName;
import org.dfra.app.terminal.ConsoleMessages;
import org.dfra.app.terminal.StatusHighlighter;
import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.BootClassPath;
import org.dfra.river.loading.TrustedCode;
import org.dfra.text.PrintableText;
import org.slf4j.bridge.SLF4JBridgeHandler;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ScopeType;

/** The command line {@code ./dfra}. */
@Command(
    name = "dfra",
    description = "The Distributed Field Robot Architecture.",
    version = Main.VERSION,
    mixinStandardHelpOptions = true,
    scope = ScopeType.INHERIT,
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {
      UpCommand.class,
      DownCommand.class,
      StatusCommand.class,
      StopCommand.class,
      DoctorCommand.class,
      TaskCommand.class,
      ModuleCommand.class,
      PersonaCommand.class,
      EventCommand.class,
      LeaseCommand.class,
      LogCommand.class,
      FuzzyCommand.class,
      RecruitCommand.class,
      DemoCommand.class,
      SimCommand.class,
      BenchCommand.class,
      CompletionCommand.class,
      HelpCommand.class
    })
public final class Main {

  static final String VERSION = "dfra 0.1.0";

  /** These commands need the full list of subcommands. */
  private static final Set<Class<?>> NEED_ALL_COMMANDS =
      Set.of(CompletionCommand.class, HelpCommand.class);

  private Main() {}

  /** The command line when a subcommand is named: loading all subcommands takes 0.2 s. */
  @Command(
      name = "dfra",
      version = VERSION,
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
    Thread.setDefaultUncaughtExceptionHandler(Main::report);
    try {
      BootClassPath.require();
      TrustedCode.install();
    } catch (IOException | IllegalStateException e) {
      System.err.println(ConsoleMessages.prefixed(String.valueOf(e.getMessage())));
      System.exit(1);
    }
    CommandLine line = commandLine(args);
    line.setOut(CommandName.replacingName(line.getOut()));
    line.setErr(CommandName.replacingName(line.getErr()));
    System.exit(line.execute(args));
  }

  /** For example an error thrown by a proxy, whose code another computer supplies. */
  private static void report(Thread thread, Throwable thrown) {
    String name = PrintableText.name(thread.getName());
    System.err.print("Thread " + name + ": " + PrintableTrace.of(thrown));
  }

  /** The full command line, for commands that inspect it. */
  static CommandLine commandLine() {
    CommandLine line = prepared(new CommandLine(new Main()));
    line.getCommandSpec().usageMessage().footer(ScriptVerbs.help()); // not inherited by subcommands
    return line;
  }

  /**
   * The command line for the given arguments; it has all subcommands only if more than one is
   * needed.
   */
  static CommandLine commandLine(String[] args) {
    Optional<Class<?>> verb = args.length == 0 ? Optional.empty() : verb(args[0]);
    if (verb.isEmpty()) {
      return commandLine();
    }
    CommandLine line = new CommandLine(new OneVerb());
    line.addSubcommand(verb.get());
    return prepared(line);
  }

  private static Optional<Class<?>> verb(String name) {
    Class<?>[] all = Main.class.getAnnotation(Command.class).subcommands();
    return Arrays.stream(all)
        .filter(each -> !NEED_ALL_COMMANDS.contains(each))
        .filter(each -> each.getAnnotation(Command.class).name().equals(name))
        .findFirst();
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
}
