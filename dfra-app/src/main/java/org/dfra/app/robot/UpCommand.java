package org.dfra.app.robot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dfra.app.team.PhoenixOptions;
import org.dfra.app.terminal.Answer;
import org.dfra.app.terminal.ExitCode;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.robot.Rehearsal;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.loading.RobotClasses;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra up}. */
@Command(
    name = "up",
    description = "Brings robots up on this host: phoenix, their registrars and their modules.",
    footer = {
      "",
      "Phoenix is started where none answers, and stays when this command ends.",
      "Running it again does no harm: what is registered keeps its identity and",
      "gets the new description."
    })
public final class UpCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "ROBOT.XML",
      arity = "0..*",
      description = "The robots' descriptions (default: that of atrv1, which comes with DFRA).")
  private List<Path> xml =
      List.of(Path.of(System.getProperty("dfra.root", ""), "config", "robots", "atrv1.xml"));

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private PhoenixOptions options;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private Answer answer;

  /**
   * What was brought up.
   *
   * @param name {@code robot/module}, or {@code robot/registrar}
   * @param group name of its service group
   * @param stopped whether it is an effector that is stopped for an emergency
   */
  record Up(String name, String group, boolean stopped) {}

  @Override
  public Integer call() throws Exception {
    List<RobotDescription> robots = new ArrayList<>();
    for (Path each : xml) { // all are read and tried before anything is begun
      robots.add(RobotXml.read(each));
    }
    Rehearsal.of(robots);
    PhoenixProcess phoenix = options.last();
    if (!phoenix.answers()) {
      // Its address is in every proxy that brings a module back, so others must reach it too.
      Map.Entry<PhoenixProcess, Process> started =
          options.start(HostAddress.resolve(robots.get(0).host()));
      phoenix = started.getKey();
      long pid = started.getValue().pid();
      say("Started phoenix: process " + pid + ", log " + phoenix.log() + ".");
    } else {
      say("Phoenix answers on port " + phoenix.port() + " of " + phoenix.host() + ".");
    }
    options.noteProcess(phoenix);
    List<Up> services = new ArrayList<>();
    for (RobotDescription robot : robots) {
      RobotBootstrap bootstrap = new RobotBootstrap(phoenix, robot);
      for (RobotBootstrap.Service service : bootstrap.up()) {
        String module = service.name().substring(service.name().indexOf('/') + 1);
        List<String> stops = Stops.sentences(phoenix.state(), robot.name(), List.of(module));
        services.add(new Up(service.name(), service.group(), !stops.isEmpty()));
        say("Up: " + service.name() + " in group " + service.group() + ".");
        stops.forEach(each -> say("But " + each + "."));
      }
      sayClasses(bootstrap);
      OtherJars.sentences(phoenix, robot.name()).forEach(each -> say(each + "."));
    }
    if (answer.isJson()) {
      answer.outline(services);
    } else {
      say("How they are: ./dfra status");
    }
    return ExitCode.WELL;
  }

  /** A robot without its class server works, but not for clients that lack its classes. */
  private void sayClasses(RobotBootstrap bootstrap) throws IOException {
    Optional<RobotClasses> classes = bootstrap.classes();
    if (classes.isPresent()) {
      String place = classes.get().host() + ":" + classes.get().port();
      Optional<String> fault = classes.get().missing();
      say(
          fault.isPresent()
              ? "Classes: " + fault.get() + "."
              : "Classes: served at " + place + ".");
    }
  }

  private void say(String sentence) {
    if (!answer.isJson()) {
      answer.line(sentence, sentence);
    }
  }
}
