/** How commands find the modules that they are about. */
package org.dfra.cli.team;
