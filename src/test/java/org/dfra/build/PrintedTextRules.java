package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ConsoleMessages;
import org.dfra.text.PrintableText;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;

/**
 * What is shown to people goes through {@link PrintableText}. Only the classes that are named here
 * write to a terminal or paint text; another one is reviewed, and then added.
 *
 * <p>{@link ArchitectureTest} runs them: a class of its own might run in another process, which
 * would read all classes again.
 */
abstract class PrintedTextRules {

  /** They write text that other computers may have written, and make it printable themselves. */
  private static final Set<String> PRINTABLE =
      Set.of(
          "org.dfra.cli.HelpCommand",
          "org.dfra.cli.Main",
          "org.dfra.cli.CommandExceptionHandler",
          "org.dfra.cli.UsageErrorHandler",
          "org.dfra.benchmarks.Report",
          "org.dfra.report.progress.ProgressReporter",
          "org.dfra.examples.harness.DemoRunner",
          "org.dfra.cli.log.LogbackSetup",
          "org.dfra.examples.mission.process.ProcessMission",
          "org.dfra.examples.sim.RunCommand",
          "org.dfra.report.terminal.CommandOutput",
          "org.dfra.river.phoenix.GroupVm",
          "org.dfra.sim.device.gps.ReceiverEmulatorMain");

  /** They write no text but their own, or hand the writer on to one of those above. */
  private static final Set<String> OWN_TEXT =
      Set.of(
          "org.dfra.benchmarks.BenchCommand",
          "org.dfra.benchmarks.ListenerMain",
          "org.dfra.benchmarks.attack.AttackTask", // these to the benchmark, which reads them
          "org.dfra.benchmarks.attack.BombServer",
          "org.dfra.benchmarks.attack.HonestRobot",
          "org.dfra.benchmarks.attack.NeutralLoad",
          "org.dfra.benchmarks.attack.Operator",
          "org.dfra.benchmarks.call.BusyTask",
          "org.dfra.benchmarks.call.CallClientTask",
          "org.dfra.benchmarks.call.CallServerTask",
          "org.dfra.benchmarks.scale.ObserverTask",
          "org.dfra.benchmarks.scale.RobotTask",
          "org.dfra.benchmarks.scale.TeamView",
          "org.dfra.examples.security.RogueRegistrarMain", // to the demonstration, which reads it
          "org.dfra.benchmarks.event.EventListenerTask",
          "org.dfra.benchmarks.event.EventServerTask",
          "org.dfra.benchmarks.start.ComputingTask",
          "org.dfra.benchmarks.task.TaskMain",
          "org.dfra.benchmarks.MicroTask", // likewise
          "org.dfra.cli.archive.ArchivedClasses", // the help of commands, to nobody
          "org.dfra.cli.completion.CompletionCommand",
          "org.dfra.examples.DemoCommand",
          "org.dfra.experiments.recruit.ExperimentCommand",
          "org.dfra.core.time.Timing",
          "org.dfra.testing.SerialCable");

  private static final Set<String> WRITERS =
      Set.of(PrintStream.class.getName(), PrintWriter.class.getName());

  /** The classes one of whose accesses is such, by the names of their files. */
  private static Set<String> thatAccess(Predicate<JavaAccess<?>> such) {
    return MainClasses.ALL.stream()
        .filter(each -> each.getAccessesFromSelf().stream().anyMatch(such))
        .map(PrintedTextRules::outermost)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static String outermost(JavaClass each) {
    String name = each.getName();
    int nested = name.indexOf('$');
    return nested < 0 ? name : name.substring(0, nested);
  }

  private static boolean writes(JavaAccess<?> access) {
    String owner = access.getTargetOwner().getName();
    String name = access.getTarget().getName();
    return WRITERS.contains(owner)
        || (owner.equals(System.class.getName()) && Set.of("out", "err").contains(name))
        || (owner.equals(CommandLine.class.getName())
            && Set.of("getOut", "getErr", "usage").contains(name));
  }

  @Test
  void onlyTheseWriteToATerminal() {
    assertThat(thatAccess(PrintedTextRules::writes))
        .containsExactlyInAnyOrderElementsOf(
            Stream.concat(PRINTABLE.stream(), OWN_TEXT.stream()).toList());
  }

  @Test
  void theyMakeTextPrintable() {
    Set<String> means =
        Stream.of(PrintableText.class, ConsoleMessages.class, CommandOutput.class)
            .map(Class::getName)
            .collect(Collectors.toSet());
    assertThat(thatAccess(access -> means.contains(access.getTargetOwner().getName())))
        .containsAll(PRINTABLE)
        .contains(
            "org.dfra.report.terminal.Json",
            "org.dfra.report.terminal.Table",
            "org.dfra.cli.doctor.FindingPrinter",
            "org.dfra.cli.log.LineEncoder",
            "org.dfra.cli.log.PrintableTrace",
            "org.dfra.report.plot.HtmlReport",
            "org.dfra.report.plot.PanelText",
            "org.dfra.river.phoenix.host.PrintableOutputStream");
  }

  /** Text of a picture is made printable where it is painted. */
  @Test
  void onlyTheseWriteTextIntoAPicture() {
    List<String> paint = List.of("drawString", "drawGlyphVector", "setTextContent");
    assertThat(thatAccess(access -> paint.contains(access.getTarget().getName())))
        .containsExactlyInAnyOrder(
            "org.dfra.report.plot.PanelText", "org.dfra.report.plot.SvgCanvas");
  }
}
