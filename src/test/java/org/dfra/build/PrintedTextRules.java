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
import org.dfra.app.terminal.CommandOutput;
import org.dfra.app.terminal.ConsoleMessages;
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
          "org.dfra.app.HelpCommand",
          "org.dfra.app.Main",
          "org.dfra.app.CommandExceptionHandler",
          "org.dfra.app.UsageErrorHandler",
          "org.dfra.app.benchmark.Report",
          "org.dfra.app.demo.harness.ProgressReporter",
          "org.dfra.app.demo.harness.DemoRunner",
          "org.dfra.app.log.LogbackSetup",
          "org.dfra.app.raster.process.ProcessMission",
          "org.dfra.app.sim.RunCommand",
          "org.dfra.app.terminal.CommandOutput",
          "org.dfra.river.phoenix.GroupVm",
          "org.dfra.sim.device.ReceiverEmulatorMain");

  /** They write no text but their own, or hand the writer on to one of those above. */
  private static final Set<String> OWN_TEXT =
      Set.of(
          "org.dfra.app.benchmark.BenchCommand",
          "org.dfra.app.benchmark.ListenerMain",
          "org.dfra.app.benchmark.attack.AttackTask", // these to the benchmark, which reads them
          "org.dfra.app.benchmark.attack.BombServer",
          "org.dfra.app.benchmark.attack.HonestRobot",
          "org.dfra.app.benchmark.attack.NeutralLoad",
          "org.dfra.app.benchmark.attack.Operator",
          "org.dfra.app.benchmark.attack.TaskMain",
          "org.dfra.app.completion.CompletionCommand",
          "org.dfra.app.demo.DemoCommand",
          "org.dfra.app.recruit.ExperimentCommand",
          "org.dfra.app.terminal.CommandName",
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
            "org.dfra.app.terminal.Json",
            "org.dfra.app.terminal.Table",
            "org.dfra.app.doctor.FindingPrinter",
            "org.dfra.app.log.LineEncoder",
            "org.dfra.app.log.PrintableTrace",
            "org.dfra.app.plot.HtmlReport",
            "org.dfra.app.plot.PanelText",
            "org.dfra.river.phoenix.PrintableOutputStream");
  }

  /** Text of a picture is made printable where it is painted. */
  @Test
  void onlyTheseWriteTextIntoAPicture() {
    List<String> paint = List.of("drawString", "drawGlyphVector", "setTextContent");
    assertThat(thatAccess(access -> paint.contains(access.getTarget().getName())))
        .containsExactlyInAnyOrder("org.dfra.app.plot.PanelText", "org.dfra.app.plot.SvgCanvas");
  }
}
