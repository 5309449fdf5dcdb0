package org.dfra.river.contract;

import java.time.InstantSource;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.effector.DriveEffector;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** The implementation alone, without any network. */
class EffectorImplementationContractTest extends EffectorContract {

  private final ScriptedDrive drive =
      new ScriptedDrive(new ModuleContext("atrv1", "drive", PARAMETERS, InstantSource.system()));

  @BeforeEach
  void start() {
    drive.start();
  }

  @AfterEach
  @Override
  void end() {
    drive.close();
  }

  @Override
  DriveEffector effector() {
    return drive;
  }

  @Override
  ScriptedDrive driver() {
    return drive;
  }

  @Override
  String commander() {
    return "a module in its own virtual machine";
  }
}
