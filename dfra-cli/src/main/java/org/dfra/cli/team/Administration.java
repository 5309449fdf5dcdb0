package org.dfra.cli.team;

import java.rmi.RemoteException;
import net.jini.admin.Administrable;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.remote.ModuleAdmin;

/** Administrative access to modules. */
public final class Administration {

  private Administration() {}

  /**
   * A module's administration.
   *
   * @throws CommandFailure if it has none
   */
  public static ModuleAdmin of(ModuleListing<? extends Module> listing) throws RemoteException {
    if (listing.module() instanceof Administrable administrable
        && administrable.getAdmin() instanceof ModuleAdmin admin) {
      return admin;
    }
    throw new CommandFailure(
        ExitCode.FAILED, listing.path() + " has no administration, so this cannot be done");
  }
}
