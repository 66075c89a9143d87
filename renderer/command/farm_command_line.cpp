#include "renderer/command/farm_command_line.h"

#include "renderer/command/shared_options.h"

namespace command {
namespace {

/// Adds the flags by which a command reaches the server.
void add_access(CLI::App& command, FarmArguments& access) {
  command.add_option("--server", access.server, "the farm's server (nats://127.0.0.1:4222)")
      ->type_name("URL");
  command.add_option("--token-file", access.token_file, "file with the server's token")->type_name("FILE");
  command
      .add_option("--tls-ca", access.tls_authority,
                  "certificates of the authority that the server's certificate is signed by")
      ->type_name("FILE.pem");
  CLI::Option* certificate =
      command
          .add_option("--tls-cert", access.tls_certificate, "own certificate, for servers that ask for one")
          ->type_name("FILE.pem");
  CLI::Option* key =
      command.add_option("--tls-key", access.tls_key, "key of the own certificate")->type_name("FILE.pem");
  certificate->needs(key);
  key->needs(certificate);
}

}  // namespace

FarmCommandLine::FarmCommandLine(CLI::App& app)
    : farm_(*app.add_subcommand("farm", "Render on many machines, see renderer/FARM.md")) {
  farm_.require_subcommand(1);
  add_serve();
  add_work();
  add_render();
  add_others();
}

void FarmCommandLine::add_serve() {
  CLI::App* serve = farm_.add_subcommand(
      "serve", "Start the farm's server, a nats-server, until Ctrl-C; print what to type on other machines");
  serve->add_option("--folder", serve_.folder, "folder for what the server keeps, its log too (farm)")
      ->type_name("FOLDER");
  serve
      ->add_option("--host", serve_.host,
                   "address to listen on (127.0.0.1, or with --token-file or --tls-ca all of this machine)")
      ->type_name("ADDRESS");
  serve->add_option("--port", serve_.port, "port to listen on (4222)")
      ->type_name("N")
      ->check(CLI::Range(1, 65535));
  FarmArguments& access = serve_.access;
  serve->add_option("--token-file", access.token_file, "file with the token that others need")
      ->type_name("FILE");
  serve->add_option("--tls-cert", access.tls_certificate, "certificate of the server: connections use TLS")
      ->type_name("FILE.pem");
  serve->add_option("--tls-key", access.tls_key, "key of the server's certificate")->type_name("FILE.pem");
  serve
      ->add_option("--tls-ca", access.tls_authority,
                   "certificates of the authority that signs those of others, which they then need")
      ->type_name("FILE.pem");
}

void FarmCommandLine::add_work() {
  CLI::App* work = farm_.add_subcommand("work", "Render parts of the farm's jobs, until Ctrl-C");
  add_access(*work, work_.access);
  work->add_option("--threads", work_.threads, "parts to render at a time, 0: one per core (0)")
      ->type_name("N")
      ->check(CLI::Range(0, 4096));
  work->add_option("--cache", work_.cache_folder, "folder for scenes (~/.cache/granada/farm)")
      ->type_name("FOLDER");
  work->add_option("--cache-limit", work_.cache_gigabytes,
                   "size of that folder, beyond which the scenes that were not used longest are removed (10)")
      ->type_name("GIGABYTES")
      ->check(CLI::Range(0.0, 1e6));
}

void FarmCommandLine::add_render() {
  CLI::App* render = farm_.add_subcommand(
      "render", "Render a scene, or a job file of `bpt pack`, on the farm; Ctrl-C leaves it resumable");
  add_scene_options(*render, render_.scene, render_.flags);
  render->add_option("-o,--output", render_.outputs, "output image; may be repeated for other file types")
      ->required()
      ->type_name("path")
      ->allow_extra_args(false);
  add_access(*render, render_.access);
  render
      ->add_option("--part-seconds", render_.part_seconds,
                   "time that a part takes about, on one thread of this machine (2)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.001, 3600.0));
  render
      ->add_option("--lease", render_.lease_seconds,
                   "time without a sign of its worker after which a part is given to another (20)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.5, 3600.0));
  add_progress(*render, render_.progress);
  render->add_flag("--json", render_.access.json,
                   "print the summary as JSON; with --progress json, on one more line");
}

void FarmCommandLine::add_others() {
  CLI::App* status = farm_.add_subcommand("status", "Print the jobs and the workers of the farm");
  CLI::App* list = farm_.add_subcommand("list", "Print the jobs of the farm");
  CLI::App* stop = farm_.add_subcommand("stop", "Stop a job; what is rendered stays, and it can be resumed");
  stop->add_option("job", job_, "its identifier, as `bpt farm list` prints it")->required()->type_name("JOB");
  for (CLI::App* command : {status, list, stop}) {
    add_access(*command, other_);
    command->add_flag("--json", other_.json, "print one JSON object");
  }
}

grf::ExitCode FarmCommandLine::run() const {
  if (farm_.got_subcommand("serve")) return farm_serve(serve_);
  if (farm_.got_subcommand("work")) return farm_work(work_);
  if (farm_.got_subcommand("render")) return farm_render(render_);
  if (farm_.got_subcommand("stop")) return farm_stop(job_, other_);
  return farm_.got_subcommand("list") ? farm_list(other_) : farm_status(other_);
}

}  // namespace command
